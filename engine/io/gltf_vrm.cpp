#include "engine/io/gltf_vrm.h"

#include <cmath>

#include "engine/io/gltf_schema.h"

namespace sinew::gltf {
namespace {

using nlohmann::json;

/// VRM 1.0 counts the thumb from the metacarpal; VRM 0.x called the same bones one joint further out.
std::string modern_name(const std::string& name) {
  for (const std::string side : {"left", "right"}) {
    if (name == side + "ThumbProximal") return side + "ThumbMetacarpal";
    if (name == side + "ThumbIntermediate") return side + "ThumbProximal";
  }
  return name;
}

void add_bone(Document& document, const std::string& name, const json* node, const std::string& place,
              std::map<std::string, int>& bones) {
  const double index = node != nullptr && node->is_number() ? node->get<double>() : -1.0;
  const auto nodes = static_cast<double>(document.gltf.nodes.size());
  // UniVRM writes -1 for bones that the avatar does not have.
  if (index == -1.0 && node != nullptr && node->is_number()) return;
  if (!(index >= 0.0 && index < nodes && index == std::floor(index)))
    document.problem("{}: the bone {:.40} names no node of the file; ignored", place, name);
  else if (!bones.emplace(name, static_cast<int>(index)).second)
    document.problem("{}: the bone {:.40} is given twice; the first stands", place, name);
}

}  // namespace

std::map<std::string, int> read_vrm_bones(Document& document) {
  std::map<std::string, int> bones;
  const json* modern = find(document.source, {"extensions", "VRMC_vrm", "humanoid", "humanBones"});
  const json* animation = find(document.source, {"extensions", "VRMC_vrm_animation", "humanoid", "humanBones"});
  const json* older = find(document.source, {"extensions", "VRM", "humanoid", "humanBones"});
  if (modern != nullptr && modern->is_object()) {
    for (const auto& [name, bone] : modern->items())
      add_bone(document, name, find(bone, {"node"}), "extensions/VRMC_vrm/humanoid", bones);
  } else if (animation != nullptr && animation->is_object()) {
    for (const auto& [name, bone] : animation->items())
      add_bone(document, name, find(bone, {"node"}), "extensions/VRMC_vrm_animation/humanoid", bones);
  } else if (older != nullptr && older->is_array()) {
    for (const json& bone : *older) {
      const json* name = find(bone, {"bone"});
      if (name != nullptr && name->is_string())
        add_bone(document, modern_name(name->get<std::string>()), find(bone, {"node"}), "extensions/VRM/humanoid",
                 bones);
    }
  }
  return bones;
}

}  // namespace sinew::gltf
