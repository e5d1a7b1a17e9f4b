#include "engine/io/gltf_morph.h"

#include "engine/io/gltf_access.h"
#include "engine/io/gltf_schema.h"

namespace sinew::gltf {
namespace {

constexpr int position_types[] = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
                                  TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_SHORT,
                                  TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};
constexpr int normal_types[] = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
                                TINYGLTF_COMPONENT_TYPE_SHORT};

Result<std::vector<Vec3>> read_changes(Document& document, int accessor, const std::string& place,
                                       std::span<const int> types) {
  auto numbers =
      read_accessor(document, accessor, place, {TINYGLTF_TYPE_VEC3, types, "VEC3 of floats, bytes or shorts"});
  if (!numbers) return pass_on(std::move(numbers));
  std::vector<Vec3> changes;
  changes.reserve(numbers->count());
  std::size_t bad = 0;
  for (std::size_t v = 0; v < numbers->count(); ++v) {
    const bool finite = numbers->finite(v);
    bad += finite ? 0 : 1;
    changes.push_back(finite ? numbers->vec3(v) : Vec3(0.0));
  }
  if (bad > 0) document.problem("{}: {} vertices are not finite; not moved", place, bad);
  return changes;
}

}  // namespace

std::vector<std::string> read_target_names(const Document& document, std::size_t mesh) {
  std::vector<std::string> names;
  const nlohmann::json* list = find(document.source["meshes"][mesh], {"extras", "targetNames"});
  if (list == nullptr || !list->is_array()) return names;
  for (const auto& name : *list) names.push_back(name.is_string() ? name.get<std::string>() : "");
  return names;
}

Result<MorphTarget> empty_morph_target(Document& document, const std::string& place,
                                       const std::vector<std::string>& names, std::size_t index) {
  const bool named = index < names.size() && !names[index].empty();
  if (auto taken = document.take_memory(sizeof(MorphTarget) + (named ? names[index].size() : 0), place); !taken)
    return pass_on(std::move(taken));
  MorphTarget target;
  target.name = named ? names[index] : fmt::format("target_{}", index);
  return target;
}

Result<std::vector<MorphTarget>> read_morph_targets(Document& document, const tinygltf::Primitive& primitive,
                                                    const std::string& place, const std::vector<std::string>& names) {
  std::vector<MorphTarget> targets;
  for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
    const std::string at = fmt::format("{}/targets/{}", place, t);
    auto begun = empty_morph_target(document, at, names, t);
    if (!begun) return pass_on(std::move(begun));
    MorphTarget& target = *begun;
    if (const auto position = primitive.targets[t].find("POSITION"); position != primitive.targets[t].end()) {
      auto changes = read_changes(document, position->second, at + "/POSITION", position_types);
      if (!changes) return pass_on(std::move(changes));
      target.positions = std::move(*changes);
    }
    if (const auto normal = primitive.targets[t].find("NORMAL"); normal != primitive.targets[t].end()) {
      if (primitive.attributes.contains("NORMAL")) {
        auto changes = read_changes(document, normal->second, at + "/NORMAL", normal_types);
        if (!changes) return pass_on(std::move(changes));
        target.normals = std::move(*changes);
      } else {
        document.problem("{}/NORMAL: changes a normal that the primitive does not have; ignored", at);
      }
    }
    targets.push_back(std::move(target));
  }
  return targets;
}

}  // namespace sinew::gltf
