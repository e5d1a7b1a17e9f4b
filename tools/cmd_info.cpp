#include <fstream>
#include <iostream>

#include "engine/app/describe.h"
#include "engine/app/measure.h"
#include "engine/app/motion_use.h"
#include "engine/core/files.h"
#include "engine/model/scene_words.h"
#include "tools/command.h"
#include "tools/motion_report.h"
#include "tools/muscle_report.h"

namespace sinew::tools {
namespace {

using Json = nlohmann::ordered_json;

struct Words {
  CommonOptions common;
  std::string file;
  std::vector<std::string> poses;
  std::string clip;
  std::string girth, volume;  ///< joints to measure; empty: none
  double at = 0.5;
  bool devices = false;
};

Json vector_json(const Vec3& v) { return {v.x, v.y, v.z}; }

Json humanoid_json(const StagedCharacter& character) {
  Json json = Json::object();
  for (std::size_t i = 0; i < humanoid_bone_count; ++i)
    if (character.humanoid.node[i] >= 0)
      json[std::string(humanoid_name(static_cast<HumanoidBone>(i)))] =
          node_name(*character.model, character.humanoid.node[i]);
  return json;
}

Json clips_json(const Stage& stage) {
  Json clips = Json::array();
  for (const StagedCharacter& character : stage.characters)
    for (const Clip& clip : character.model->clips) clips.push_back({{"name", clip.name}, {"duration", clip.duration}});
  return clips;
}

/// What moves a face: regions by name, or the morph targets that stand in for them; and what its limits hold.
Json face_json(const Stage& stage) {
  Json regions = Json::array(), targets = Json::array(), held = Json::array(), landmarks = Json::object();
  for (const StagedCharacter& character : stage.characters) {
    if (character.mesh.face && regions.empty())
      for (const FaceRegion& region : face_regions()) regions.push_back(region.name);
    if (landmarks.empty())
      for (const auto& [name, place] : character.face.landmarks) landmarks[name] = vector_json(place);
    if (!character.mesh.face)
      if (const auto found = TargetFace::find(*character.model, character.mesh))
        for (const std::string& name : found->names()) targets.push_back(name);
    for (const auto& [channel, frame] : character.face.held)
      held.push_back({{"region", channel_word(channel.channel)},
                      {"asked", channel.asked},
                      {"held", channel.held},
                      {"frame", frame}});
  }
  return {{"regions", regions}, {"targets", targets}, {"landmarks", landmarks}, {"held", held}};
}

Json stage_json(const Stage& stage, bool posed) {
  const Description d = describe(stage);
  std::vector<std::string> problems = stage.problems;
  for (const StagedCharacter& character : stage.characters)
    problems.insert(problems.end(), character.humanoid.notes.begin(), character.humanoid.notes.end());
  Json json{{"vertices", d.vertices},
            {"triangles", d.triangles},
            {"joints", d.joints},
            {"max_influences", d.max_influences},
            {"clips", clips_json(stage)},
            {"humanoid", humanoid_json(stage.characters.front())},
            {"morph_targets", d.morph_targets},
            {"face", face_json(stage)},
            {"muscles", muscles_json(stage, posed)}};
  if (!d.bounds.empty()) json["bounds"] = {{"min", vector_json(d.bounds.low)}, {"max", vector_json(d.bounds.high)}};
  json["problems"] = problems;
  if (stage.is_scene) {
    json["characters"] = stage.characters.size();
    json["frames"] = {stage.range.first, stage.range.last};
    json["fps"] = stage.scene.fps;
  }
  return json;
}

/// The same for people: a line a fact, lists indented.
void print_text(const Json& json) {
  for (const auto& [key, value] : json.items()) {
    if (key == "muscles" && !value.empty()) {
      std::cout << "muscles:\n" << muscle_table(value);
      continue;
    }
    if (!value.is_structured() || value.empty() || (value.is_array() && value.front().is_number())) {
      std::cout << fmt::format("{}: {}\n", key, value.empty() && value.is_structured() ? "none" : value.dump());
      continue;
    }
    std::cout << key << ":\n";
    for (const auto& [inner_key, inner] : value.items())
      std::cout << (value.is_object()
                        ? fmt::format("  {}: {}\n", inner_key,
                                      inner.is_string() ? inner.get<std::string>() : inner.dump())
                        : fmt::format("  {}\n", inner.is_string() ? inner.get<std::string>() : inner.dump()));
  }
}

/// What --girth and --volume ask for.
Result<void> add_measures(const Stage& stage, const Words& words, Json& json) {
  if (!words.girth.empty()) {
    const auto girth = measure_girth(stage, words.girth, words.at);
    if (!girth) return bad_input("--girth {}: {}", words.girth, girth.error().message);
    json["girth"] = {{"joint", words.girth}, {"at", words.at}, {"length", girth->length}, {"tape", girth->tape}};
  }
  if (!words.volume.empty()) {
    const auto volume = measure_volume(stage, words.volume);
    if (!volume) return bad_input("--volume {}: {}", words.volume, volume.error().message);
    json["volume"] = {{"joint", words.volume},
                      {"from", volume->from},
                      {"to", volume->to},
                      {"volume", volume->volume},
                      {"open_edges", volume->open_edges}};
  }
  return {};
}

Result<void> list_devices(const Words& words) {
  const auto devices = Device::list();
  if (!devices) return tl::unexpected<Error>(devices.error());
  Json list = Json::array();
  for (std::size_t i = 0; i < devices->size(); ++i) {
    const DeviceInfo& info = (*devices)[i];
    Json json = device_json(info);
    json["index"] = i;
    if (!info.refused.empty()) json["refused"] = info.refused;
    list.push_back(json);
    if (!words.common.json)
      std::cout << fmt::format("{}: {} ({}), Vulkan {}, {}{}\n", i, info.name, info.type, info.api, info.driver,
                               info.refused.empty() ? "" : "; refused: " + info.refused);
  }
  if (words.common.json) print_json({{"devices", list}});
  return {};
}

bool holds_motion_alone(const std::string& file) {
  constexpr std::size_t head = 4096;  // what tells is at the beginning
  std::vector<unsigned char> bytes(head);
  std::ifstream in(file, std::ios::binary);
  in.read(reinterpret_cast<char*>(bytes.data()), head);
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return !bytes.empty() && is_motion_alone(file, bytes);
}

Result<void> motion_info(const Words& words) {
  if (!words.poses.empty() || !words.clip.empty() || !words.girth.empty() || !words.volume.empty())
    return bad_input("{}: is a motion: it has no body to pose or measure", words.file);
  const auto json = motion_report(words.file);
  if (!json) return tl::unexpected<Error>(json.error());
  if (words.common.json) {
    print_json(*json);
  } else {
    print_text(*json);
  }
  return {};
}

Result<void> info(const Words& words) {
  apply_verbosity(words.common);
  if (words.devices) return list_devices(words);
  if (words.file.empty())
    return failure(ErrorKind::usage, "info: name a model, a motion or a scene file, or ask for --devices");
  if (holds_motion_alone(words.file)) return motion_info(words);
  SceneWords scene;
  scene.scene = words.file;
  scene.poses = words.poses;
  scene.clip = words.clip;
  auto options = scene_options(scene);
  if (!options) return pass_on(std::move(options));
  if (!(words.at >= 0.0 && words.at <= 1.0))
    return failure(ErrorKind::usage, "--at {}: expected a share of the limb's length, 0 to 1", words.at);
  auto stage = open_stage(*options);
  if (!stage) return pass_on(std::move(stage));
  // What is measured on a bare model is its rest pose, turned by --pose, not the first moment of a clip of its own.
  if (!stage->is_scene && words.clip.empty()) stage->characters.front().clip = -1;
  Json json = stage_json(*stage, !words.poses.empty());
  if (auto ok = add_measures(*stage, words, json); !ok) return ok;
  if (words.common.json) {
    print_json(json);
  } else {
    print_text(json);
  }
  return {};
}

}  // namespace

void add_info(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("info", "What a model, a motion or a scene holds");
  command->footer("Example: sinew info character.glb --girth leftUpperArm --pose leftLowerArm=0,-90,0");
  auto words = std::make_shared<Words>();
  command->add_option("file", words->file, "A .glb, .gltf, .vrm, .bvh, .amc, .vrma or scene file");
  command->add_flag("--devices", words->devices, "List the Vulkan devices");
  command->add_option("--pose", words->poses, "JOINT=x,y,z: also report the muscles' angles in this pose")
      ->allow_extra_args(false);
  command->add_option("--clip", words->clip, "Measure at the first frame of this animation of the model's own");
  auto* girth = command->add_option("--girth", words->girth, "Also report how far it is round the limb of this joint");
  command->add_option("--at", words->at, "Where: 0 at the joint, 1 at the joint after it")
      ->capture_default_str()
      ->needs(girth);
  command->add_option("--volume", words->volume, "Also report how much the limb of this joint holds");
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return info(*words); }; });
}

}  // namespace sinew::tools
