#include <nlohmann/json.hpp>

#include "embedded/default_scene.h"
#include "engine/app/stage.h"
#include "engine/body/built_in_model.h"
#include "engine/core/files.h"
#include "engine/core/text.h"
#include "engine/io/gltf_read.h"
#include "engine/io/scene_file.h"
#include "engine/model/resample.h"
#include "engine/model/scene_words.h"
#include "engine/rig/clip_sampling.h"
#include "engine/rig/motion_file.h"

namespace sinew {
namespace {

constexpr std::size_t largest_scene_file = std::size_t{64} << 20;

/// An error, with the place in the scene file that asked for what went wrong; a bare model has no such place.
class Place {
 public:
  Place(std::string source, bool bare_model, std::size_t character)
      : prefix_(bare_model ? "" : fmt::format("{}: /characters/{}", source, character)) {}

  template <class T>
  tl::unexpected<Error> at(const std::string& pointer, Result<T>&& failed) const {
    Error error = std::move(failed.error());
    if (!prefix_.empty()) error.message = fmt::format("{}{}: {}", prefix_, pointer, error.message);
    return tl::unexpected<Error>(std::move(error));
  }

 private:
  std::string prefix_;
};

/// A scene, and whether it was made up for a bare model, which has defaults of its own.
struct OpenedScene {
  Scene scene;
  bool bare_model = false;
  std::optional<Bytes> model_bytes = std::nullopt;  ///< of a bare model's file, which was read to see what it is
};

OpenedScene bare_model_scene(const std::string& model) {
  OpenedScene opened;
  opened.bare_model = true;
  opened.scene.characters.emplace_back().model = model;
  return opened;
}

Result<OpenedScene> open_scene(const std::string& source) {
  if (source.empty()) {
    auto scene = parse_scene(default_scene, "the embedded scene", ".");
    if (!scene) return pass_on(std::move(scene));
    return OpenedScene{std::move(*scene), false};
  }
  if (is_built_in_model(source)) return bare_model_scene(source);
  auto bytes = read_file(source);
  if (!bytes) return pass_on(std::move(bytes));
  if (bytes->size() <= largest_scene_file && looks_like_scene(*bytes)) {
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    auto scene = parse_scene(text, source, std::filesystem::path(source).parent_path());
    if (!scene) return pass_on(std::move(scene));
    return OpenedScene{std::move(*scene), false};
  }
  if (is_motion_alone(source, *bytes)) {
    OpenedScene opened = bare_model_scene("builtin:figure");
    opened.scene.characters.front().motion = MotionUse{.source = MotionFile{source, ""}};
    return opened;
  }
  OpenedScene opened = bare_model_scene(source);
  opened.model_bytes = std::move(*bytes);
  return opened;
}

/// Of the file, which `hash` has seen, and of all that it refers to: buffers and pictures may lie in files of their
/// own.
std::string content_hash(Sha256& hash, const Model& model) {
  for (const EncodedImage& image : model.images) hash.add(image.bytes);
  for (const Skin& skin : model.skins) hash.add_all(skin.inverse_bind);
  for (const Clip& clip : model.clips)
    for (const Channel& channel : clip.channels) {
      hash.add_all(channel.times);
      hash.add_all(channel.values);
    }
  for (const Mesh& mesh : model.meshes)
    for (const Primitive& primitive : mesh.primitives) {
      hash.add_all(primitive.positions);
      hash.add_all(primitive.normals);
      hash.add_all(primitive.tangents);
      hash.add_all(primitive.texture_coordinates);
      hash.add_all(primitive.second_texture_coordinates);
      hash.add_all(primitive.colours);
      hash.add_all(primitive.indices);
      hash.add_all(primitive.influences.first);
      for (const Influence& influence : primitive.influences.entries)
        hash.add_all(std::vector<double>{double(influence.joint), influence.weight});
      for (const MorphTarget& target : primitive.morph_targets) {
        hash.add_all(target.positions);
        hash.add_all(target.normals);
      }
    }
  return hash.finish();
}

/// Reads the file once, so that the hash is that of what was parsed, whoever replaces the file meanwhile.
Result<void> load_model(StagedCharacter& character, std::optional<Bytes> bytes) {
  const std::string name = character.scene.model.string();
  if (is_built_in_model(name)) {
    auto model = built_in_model(name);
    if (!model) return pass_on(std::move(model));
    character.model = std::make_unique<Model>(std::move(*model));
    character.model_hash = name;
    return {};
  }
  if (!bytes) {
    auto read = read_file(character.scene.model);
    if (!read) return pass_on(std::move(read));
    bytes = std::move(*read);
  }
  Sha256 hash;
  hash.add(*bytes);
  auto model = read_gltf(character.scene.model, std::move(*bytes));
  if (!model) return pass_on(std::move(model));
  character.model_hash = content_hash(hash, *model);
  character.model = std::make_unique<Model>(std::move(*model));
  return {};
}

Result<void> choose_clip(StagedCharacter& character, const SceneOptions& options, bool bare_model, const Place& place) {
  std::optional<ClipChoice> choice = options.clip ? options.clip : character.scene.clip;
  if (!choice && bare_model && !character.model->clips.empty()) choice = 0;
  if (!choice) return {};
  auto clip = find_clip(*character.model, *choice);
  if (!clip) return options.clip ? pass_on(std::move(clip)) : place.at("/clip", std::move(clip));
  character.clip = *clip;
  return {};
}

Result<void> find_tracks(StagedCharacter& character, const Place& place) {
  for (const auto& [joint, keys] : character.scene.keys) {
    auto node = find_joint(*character.model, character.humanoid, joint);
    if (!node) return place.at("/keys/" + joint, std::move(node));
    const bool added = character.scene.motion && character.scene.motion->keys == KeyBlend::add;
    character.tracks.push_back({*node, keys, added});
  }
  return {};
}

/// --pose turns the joint of that name in every character that has it.
Result<void> add_poses(Stage& stage, const std::vector<PoseOption>& poses) {
  for (const PoseOption& pose : poses) {
    std::optional<Error> unknown;
    bool found = false;
    for (StagedCharacter& character : stage.characters) {
      const auto node = find_joint(*character.model, character.humanoid, pose.joint);
      if (!node) {
        unknown = node.error();
        continue;
      }
      character.tracks.push_back({*node, Keyed<Vec3>::constant(pose.degrees)});
      found = true;
    }
    if (!found)
      return bad_input("--pose {}: {}", pose.joint, unknown ? unknown->message : "the scene has no character");
  }
  return {};
}

Result<void> place_muscles(StagedCharacter& character, bool bare_model, const Place& place,
                           std::vector<std::string>& problems) {
  const PlacementContext context{*character.model, character.mesh, character.rest, character.humanoid};
  if (bare_model) {
    character.muscles = default_muscles(context, problems);
    return {};
  }
  for (std::size_t i = 0; i < character.scene.muscles.size(); ++i) {
    auto placed = place_muscle(context, character.scene.muscles[i]);
    if (!placed) return place.at(fmt::format("/muscles/{}", i), std::move(placed));
    character.muscles.push_back(std::move(*placed));
  }
  return {};
}

/// What follows from the model alone.
Result<void> prepare_model(StagedCharacter& character, const SceneOptions& options, std::optional<Bytes> bytes) {
  if (auto ok = load_model(character, std::move(bytes)); !ok) return ok;
  const Model& model = *character.model;
  character.order = hierarchy_order(model);
  character.rest_rotations = rest_rotations(model, character.order);
  if (auto ok = check_drawn_vertices(model); !ok) return ok;
  character.mesh = character_mesh(model);
  if (options.vertices > 0) {
    auto mesh = resample(character.mesh, options.vertices);
    if (!mesh) return bad_input("{}: {}", character.scene.model.string(), mesh.error().message);
    character.mesh = std::move(*mesh);
  }
  character.rest = rest_shape(model, character.mesh, character.order);
  for (MeshPart& part : character.mesh.parts)
    if (part.vertex_count > 0) part.mirrored = glm::determinant(character.rest.blend[part.first_vertex]) < 0.0;
  character.humanoid = find_humanoid(model, character.rest.global);
  return {};
}

Result<void> prepare(StagedCharacter& character, const SceneOptions& options, OpenedScene& opened, const Place& place,
                     std::vector<std::string>& problems) {
  const bool bare_model = opened.bare_model;
  auto bytes = std::exchange(opened.model_bytes, std::nullopt);
  if (auto ok = prepare_model(character, options, std::move(bytes)); !ok) return place.at("/model", std::move(ok));
  std::vector<std::string> found = character.model->problems;
  if (auto ok = choose_clip(character, options, bare_model, place); !ok) return ok;
  if (const auto& use = character.scene.motion) {
    auto motion = stage_motion(*use, options.library, *character.model, character.humanoid, found);
    if (!motion) return place.at("/motion", std::move(motion));
    character.motion = std::move(*motion);
  }
  if (auto ok = find_tracks(character, place); !ok) return ok;
  if (auto ok = place_muscles(character, bare_model, place, found); !ok) return ok;
  if (character.mesh.triangles.empty()) found.push_back("has no triangles; nothing of it is shown");
  for (const PlacedMuscle& placed : character.muscles)
    for (std::string& problem : placement_problems(placed)) found.push_back(std::move(problem));
  for (const std::string& problem : found)
    problems.push_back(fmt::format("{}: {}", character.scene.model.string(), problem));
  return {};
}

/// What a character asks for that this program cannot do yet: said, not ignored.
void note_unsupported(const Character& character, std::vector<std::string>& problems) {
  const auto note = [&](bool asked, const char* what) {
    if (asked) problems.push_back(fmt::format("{}: \"{}\" is not shown yet", character.model.string(), what));
  };
  note(character.expressions.has_value(), "expressions");
  note(!character.regions.empty(), "regions");
  note(!character.emotion.empty(), "emotion");
}

/// From frame 0 to the last frame that a clip or a key has.
FrameSpan natural_range(const Stage& stage) {
  double last = 0.0;
  const auto reach = [&](const auto& keyed) { last = std::max(last, std::ceil(keyed.keys.back().frame)); };
  const Camera& camera = stage.scene.camera;
  reach(camera.orbit);
  if (camera.target) reach(*camera.target);
  if (camera.distance) reach(*camera.distance);
  for (const StagedCharacter& character : stage.characters) {
    reach(character.scene.position);
    reach(character.scene.turn);
    // A duration that is a whole number of frames up to rounding must not grow by one.
    if (character.clip >= 0)
      last = std::max(last, std::ceil(character.model->clips[character.clip].duration * stage.scene.fps - 1e-6));
    if (character.motion) last = std::max(last, std::ceil(last_frame(*character.motion, stage.scene.fps) - 1e-6));
    for (const StagedCharacter::JointTrack& track : character.tracks) reach(track.degrees);
  }
  return {0, static_cast<int>(std::clamp(last, 0.0, 1e7))};
}

std::string hash_scene(const Stage& stage, const SceneOptions& options) {
  nlohmann::ordered_json json;
  Scene scene = stage.scene;
  scene.frames = stage.range;
  // Where a model lies does not change what is shown; what is in it does.
  for (std::size_t i = 0; i < scene.characters.size(); ++i) {
    scene.characters[i].model = stage.characters[i].model_hash;
    if (const auto& motion = stage.characters[i].motion)
      scene.characters[i].motion->source = LibraryClip{motion->content_hash};
  }
  json["scene"] = scene_text(scene, {});
  for (const StagedCharacter& character : stage.characters) {
    json["clips"].push_back(character.clip);
    for (const PlacedMuscle& placed : character.muscles) json["muscles"].push_back(placed.muscle.name);
  }
  for (const PoseOption& pose : options.poses)
    json["poses"].push_back({pose.joint, pose.degrees.x, pose.degrees.y, pose.degrees.z});
  json["strength"] = stage.strength;
  return sha256(json.dump());
}

}  // namespace

Result<Stage> open_stage(const SceneOptions& options) {
  auto opened = open_scene(options.scene);
  if (!opened) return pass_on(std::move(opened));
  Stage stage;
  stage.source = options.scene.empty() ? "the embedded scene" : options.scene;
  stage.scene = std::move(opened->scene);
  stage.is_scene = !opened->bare_model;
  stage.strength = options.strength;
  if (options.fps) stage.scene.fps = *options.fps;
  SceneOptions with_library = options;
  if (stage.scene.library) with_library.library = *stage.scene.library;
  for (const Character& character : stage.scene.characters) {
    note_unsupported(character, stage.problems);
    const Place place(stage.source, opened->bare_model, stage.characters.size());
    StagedCharacter& staged = stage.characters.emplace_back();
    staged.scene = character;
    if (auto ok = prepare(staged, with_library, *opened, place, stage.problems); !ok) return pass_on(std::move(ok));
  }
  if (auto ok = add_poses(stage, options.poses); !ok) return bad_input("{}: {}", stage.source, ok.error().message);
  stage.range = stage.scene.frames.value_or(natural_range(stage));
  stage.scene_hash = hash_scene(stage, options);
  return stage;
}

}  // namespace sinew
