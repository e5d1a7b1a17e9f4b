#include <iostream>

#include "engine/app/describe.h"
#include "engine/core/files.h"
#include "tools/command.h"

namespace sinew::tools {
namespace {

using Json = nlohmann::ordered_json;

struct Words {
  CommonOptions common;
  std::string file;
  std::vector<std::string> poses;
  bool devices = false;
};

Json vector_json(const Vec3& v) { return {v.x, v.y, v.z}; }

std::string node_name(const Model& model, int node) {
  const std::string& name = model.nodes[node].name;
  return name.empty() ? fmt::format("nodes/{}", node) : name;
}

Json muscle_json(const Model& model, const PlacedMuscle& placed) {
  const Muscle& m = placed.muscle;
  return {{"name", m.name},
          {"bone", node_name(model, m.bone)},
          {"child", node_name(model, m.child)},
          {"driver", node_name(model, m.driver)},
          {"tip", node_name(model, m.tip)},
          {"facing", vector_json(placed.region.plane.normal)},
          {"from", m.from},
          {"to", m.to},
          {"spread", m.spread},
          {"peak", m.peak},
          {"sigma", {m.sigma.x, m.sigma.y}},
          {"rest_angle", m.rest_angle},
          {"reference_angle", m.reference_angle},
          {"centre", vector_json(placed.region.centre)},
          {"region_vertices", placed.region.vertices.size()},
          {"segment_vertices", placed.region.segment_vertices}};
}

/// The muscles of all characters, with their angle and activation where a pose was asked for.
Json muscles_json(const Stage& stage, bool posed) {
  Json muscles = Json::array();
  for (std::size_t i = 0; i < stage.characters.size(); ++i) {
    const StagedCharacter& character = stage.characters[i];
    const CharacterState state = character_state(stage, i, stage.range.first);
    for (std::size_t m = 0; m < character.muscles.size(); ++m) {
      Json json = muscle_json(*character.model, character.muscles[m]);
      if (posed) {
        json["angle"] = character.muscles[m].driver.degrees(state.global);
        json["activation"] = state.activations[m];
      }
      muscles.push_back(std::move(json));
    }
  }
  return muscles;
}

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

Result<void> info(const Words& words) {
  apply_verbosity(words.common);
  if (words.devices) return list_devices(words);
  if (words.file.empty()) return failure(ErrorKind::usage, "info: name a model or a scene file, or ask for --devices");
  SceneWords scene;
  scene.scene = words.file;
  scene.poses = words.poses;
  auto options = scene_options(scene);
  if (!options) return pass_on(std::move(options));
  auto stage = open_stage(*options);
  if (!stage) return pass_on(std::move(stage));
  const Json json = stage_json(*stage, !words.poses.empty());
  if (words.common.json) {
    print_json(json);
  } else {
    print_text(json);
  }
  return {};
}

}  // namespace

void add_info(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("info", "What a model or a scene holds");
  command->footer("Example: sinew info character.glb --json");
  auto words = std::make_shared<Words>();
  command->add_option("file", words->file, "A .glb, .gltf, .vrm or scene file");
  command->add_flag("--devices", words->devices, "List the Vulkan devices");
  command->add_option("--pose", words->poses, "JOINT=x,y,z: also report the muscles' angles in this pose")
      ->allow_extra_args(false);
  for (const char* later : {"--girth", "--at"}) add_later_option(*command, later);
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return info(*words); }; });
}

}  // namespace sinew::tools
