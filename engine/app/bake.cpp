#include "engine/app/bake.h"

#include "engine/app/device_state.h"
#include "engine/core/files.h"
#include "engine/core/frame_range.h"
#include "engine/core/interrupt.h"
#include "engine/core/temporary_file.h"
#include "engine/core/text.h"
#include "engine/face/face_shapes.h"
#include "engine/gpu/gpu_deformer.h"
#include "engine/io/gltf_write.h"
#include "engine/io/obj.h"
#include "engine/io/ply.h"
#include "engine/rig/t_pose.h"

namespace sinew {
namespace {

std::string ending_of(const std::string& output) { return lower(std::filesystem::path(output).extension().string()); }

/// Triangles and texture coordinates of all characters, one after another.
BakedMesh topology(const Stage& stage) {
  BakedMesh mesh;
  bool textured = false;
  std::uint32_t first = 0;
  for (const StagedCharacter& character : stage.characters) {
    for (const std::uint32_t index : character.mesh.triangles) mesh.triangles.push_back(first + index);
    for (const Vec2& uv : character.mesh.texture_coordinates) {
      mesh.texture_coordinates.emplace_back(uv);
      textured |= uv != Vec2(0.0);
    }
    first += static_cast<std::uint32_t>(character.mesh.vertices());
  }
  if (!textured) mesh.texture_coordinates.clear();
  return mesh;
}

/// Appends one character's vertices to a frame.
using Deform = std::function<Result<void>(std::size_t character, const CharacterState&, BakedFrame&)>;

Deform deform_by_cpu(const Stage& stage, const SceneOptions& options) {
  return [&stage, &options](std::size_t i, const CharacterState& state, BakedFrame& frame) -> Result<void> {
    const DeformedVertices d = deform_on_cpu(stage.characters[i], state, options.deformer, options.bulge);
    frame.positions.insert(frame.positions.end(), d.positions.begin(), d.positions.end());
    frame.normals.insert(frame.normals.end(), d.normals.begin(), d.normals.end());
    return {};
  };
}

Result<Deform> deform_by_gpu(Device& device, const Stage& stage, const SceneOptions& options) {
  auto deformers = std::make_shared<std::vector<GpuDeformer>>();
  for (const StagedCharacter& c : stage.characters) {
    const GpuDeformerOptions deform{.deformer = options.deformer, .bulge = options.bulge};
    auto deformer = GpuDeformer::create(device, c.mesh, c.rest, c.muscles, deform);
    if (!deformer) return pass_on(std::move(deformer));
    deformers->push_back(std::move(*deformer));
  }
  return [deformers, &stage](std::size_t i, const CharacterState& state, BakedFrame& frame) -> Result<void> {
    GpuDeformer& deformer = (*deformers)[i];
    if (auto ok = load_state(stage.characters[i], state, deformer); !ok) return ok;
    if (auto ok = deformer.run(); !ok) return ok;
    auto words = deformer.read_back();
    if (!words) return pass_on(std::move(words));
    for (std::size_t w = 0; w < words->size(); w += layout::words_per_output) {
      frame.positions.emplace_back((*words)[w]);
      frame.normals.emplace_back((*words)[w + 1]);
    }
    return {};
  };
}

Result<Deform> chosen_deform(Device* device, const Stage& stage, const BakeOptions& options) {
  if (options.by_cpu) return deform_by_cpu(stage, options.scene);
  return deform_by_gpu(*device, stage, options.scene);
}

Result<BakedFrame> bake_frame(const Stage& stage, const Deform& deform, int number) {
  BakedFrame frame;
  for (std::size_t i = 0; i < stage.characters.size(); ++i)
    if (auto ok = deform(i, character_state(stage, i, number), frame); !ok) return pass_on(std::move(ok));
  return frame;
}

/// The bytes of one file from one or more frames.
Result<Bytes> encode(const BakedMesh& mesh, const std::string& output, const Stage& stage) {
  const std::string ending = ending_of(output);
  if (ending == ".ply") return ply_bytes(mesh, 0);
  if (ending == ".glb") return baked_glb(mesh, std::filesystem::path(stage.source).stem().string());
  const std::string text =
      obj_text(mesh, 0, fmt::format("sinew: {}", std::filesystem::path(stage.source).filename().string()));
  return Bytes(text.begin(), text.end());
}

/// The character's model, its regions made into morph targets.
Model rig_of(const StagedCharacter& character) {
  Model model = *character.model;
  if (character.mesh.face) add_face_shapes(character.mesh, model);
  return model;
}

/// Ours, by the names of their morph targets.
std::vector<VrmExpression> vrm_expressions() {
  static constexpr const char* words[] = {"none", "block", "blend"};
  const auto word = [](ExpressionOverride rule) { return words[static_cast<std::size_t>(rule)]; };
  std::vector<VrmExpression> out;
  for (const FacePreset& e : expressions()) out.push_back({e.name, word(e.mouth), word(e.blink), word(e.look)});
  return out;
}

/// The character in a T pose, with its humanoid map and expressions.
Result<Bytes> vrm_of(const StagedCharacter& character, const BakeOptions& options) {
  const auto posed = in_t_pose(rig_of(character), character.humanoid);
  if (!posed) return tl::unexpected<Error>(posed.error());
  std::map<std::string, int> bones;
  for (std::size_t i = 0; i < humanoid_bone_count; ++i)
    if (character.humanoid.node[i] >= 0)
      bones[std::string(humanoid_name(static_cast<HumanoidBone>(i)))] = character.humanoid.node[i];
  VrmMeta meta = options.vrm;
  meta.values.try_emplace("name", std::vector<std::string>{std::filesystem::path(options.output).stem().string()});
  return vrm_glb(*posed, bones, meta, vrm_expressions());
}

Result<BakeReport> write_rig(const Stage& stage, const BakeOptions& options) {
  if (stage.characters.size() != 1)
    return bad_input("{}: --rig writes one character, the scene has {}", stage.source, stage.characters.size());
  const StagedCharacter& character = stage.characters.front();
  auto bytes = ending_of(options.output) == ".vrm" ? vrm_of(character, options) : rig_glb(rig_of(character));
  if (!bytes) return pass_on(std::move(bytes));
  if (auto ok = write_file(options.output, *bytes); !ok) return pass_on(std::move(ok));
  return BakeReport{1, stage.vertices(), stage.triangles()};
}

}  // namespace

Result<void> check_mesh_name(const BakeOptions& options) {
  const std::string ending = ending_of(options.output);
  if (options.rig && ending != ".glb" && ending != ".vrm")
    return failure(ErrorKind::usage, "-o {}: --rig writes a name that ends in .glb or .vrm", options.output);
  if (ending == ".vrm" && !options.rig)
    return failure(ErrorKind::usage, "-o {}: a .vrm is a rig; ask for --rig", options.output);
  if (ending != ".vrm" && !options.vrm.values.empty())
    return failure(ErrorKind::usage, "-o {}: --meta goes with a name that ends in .vrm", options.output);
  if (!options.rig && ending != ".obj" && ending != ".ply" && ending != ".glb")
    return failure(ErrorKind::usage, "-o {}: expected a name that ends in .obj, .ply or .glb", options.output);
  const bool several = options.scene.frames && options.scene.frames->size() > 1;
  if (several && ending != ".glb" && !has_frame_pattern(options.output))
    return failure(ErrorKind::usage, "-o {}: {} frames need a name with ####, such as frame_####{}", options.output,
                   options.scene.frames->size(), ending);
  return {};
}

Result<BakedMesh> bake_frames(Device* device, const Stage& stage, const BakeOptions& options,
                              const std::vector<int>& frames) {
  auto deform = chosen_deform(device, stage, options);
  if (!deform) return pass_on(std::move(deform));
  BakedMesh mesh = topology(stage);
  Progress progress("deforming", frames.size(), options.progress);
  for (const int number : frames) {
    if (auto ok = check_interrupt(); !ok) return pass_on(std::move(ok));
    auto frame = bake_frame(stage, *deform, number);
    if (!frame) return pass_on(std::move(frame));
    mesh.frames.push_back(std::move(*frame));
    mesh.times.push_back((number - frames.front()) / stage.scene.fps);
    progress.advance();
  }
  return mesh;
}

Result<BakeReport> bake(Device* device, const Stage& stage, const BakeOptions& options) {
  const bool pattern = has_frame_pattern(options.output);
  const std::vector<int> frames = selected_frames(stage, options.scene, !pattern);
  if (auto ok = check_writable(frame_file_name(options.output, frames.front())); !ok) return pass_on(std::move(ok));
  if (auto ok = check_not_an_input(stage, options.output); !ok) return pass_on(std::move(ok));
  remove_stale_temporaries(options.output);
  if (options.rig) return write_rig(stage, options);
  if (!pattern) {
    auto mesh = bake_frames(device, stage, options, frames);
    if (!mesh) return pass_on(std::move(mesh));
    auto bytes = encode(*mesh, options.output, stage);
    if (!bytes) return pass_on(std::move(bytes));
    if (auto ok = write_file(options.output, *bytes); !ok) return pass_on(std::move(ok));
    return BakeReport{frames.size(), stage.vertices(), stage.triangles()};
  }

  auto deform = chosen_deform(device, stage, options);
  if (!deform) return pass_on(std::move(deform));
  BakedMesh mesh = topology(stage);
  mesh.times = {0.0};
  Progress progress("writing", frames.size(), options.progress);
  for (const int number : frames) {
    if (auto ok = check_interrupt(); !ok) return pass_on(std::move(ok));
    auto frame = bake_frame(stage, *deform, number);
    if (!frame) return pass_on(std::move(frame));
    mesh.frames.assign(1, std::move(*frame));
    auto bytes = encode(mesh, options.output, stage);
    if (!bytes) return pass_on(std::move(bytes));
    if (auto ok = write_file(frame_file_name(options.output, number), *bytes); !ok) return pass_on(std::move(ok));
    progress.advance();
  }
  return BakeReport{frames.size(), stage.vertices(), stage.triangles()};
}

}  // namespace sinew
