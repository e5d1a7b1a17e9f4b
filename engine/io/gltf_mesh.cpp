#include "engine/io/gltf_mesh.h"

#include <algorithm>
#include <cmath>

#include "engine/io/gltf_access.h"
#include "engine/io/gltf_morph.h"
#include "engine/io/gltf_surface.h"
#include "engine/io/gltf_triangles.h"
#include "engine/io/gltf_weights.h"

namespace sinew::gltf {
namespace {

constexpr int any_component[] = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
                                 TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_SHORT,
                                 TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};
constexpr int signed_component[] = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
                                    TINYGLTF_COMPONENT_TYPE_SHORT};

/// The accessor of an attribute, or -1.
int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
  const auto at = primitive.attributes.find(name);
  return at == primitive.attributes.end() ? -1 : at->second;
}

bool is_triangles(int mode) {
  return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP || mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

/// A primitive on its way from the file into the model.
class PrimitiveReader {
 public:
  PrimitiveReader(Document& document, const tinygltf::Primitive& from, std::string place)
      : document_(document), from_(from), place_(std::move(place)) {}

  Result<Primitive> read(const Materials& materials, const std::vector<std::string>& target_names) {
    if (auto counts = check_counts(); !counts) return pass_on(std::move(counts));
    if (auto positions = read_positions(); !positions) return pass_on(std::move(positions));
    auto triangles = read_triangles(document_, from_, place_, to_.positions.size());
    if (!triangles) return pass_on(std::move(triangles));
    to_.indices = std::move(*triangles);
    if (auto normals = read_normals(); !normals) return pass_on(std::move(normals));
    if (auto surface = read_surface(document_, from_, place_, materials, to_); !surface)
      return pass_on(std::move(surface));
    auto influences = read_influences(document_, from_.attributes, place_, to_.positions.size());
    if (!influences) return pass_on(std::move(influences));
    to_.influences = std::move(*influences);
    auto targets = read_morph_targets(document_, from_, place_, target_names);
    if (!targets) return pass_on(std::move(targets));
    to_.morph_targets = std::move(*targets);
    to_.material = from_.material;
    return std::move(to_);
  }

 private:
  Result<void> check_counts() const {
    const auto count = [&](int accessor) { return document_.gltf.accessors[static_cast<std::size_t>(accessor)].count; };
    const std::size_t vertices = count(attribute(from_, "POSITION"));
    const auto check = [&](const std::map<std::string, int>& attributes, const std::string& at) -> Result<void> {
      for (const auto& [name, accessor] : attributes)
        if (count(accessor) != vertices)
          return bad_input("{}/{}: has {} elements, but POSITION has {}", at, name, count(accessor), vertices);
      return {};
    };
    if (auto same = check(from_.attributes, place_ + "/attributes"); !same) return same;
    for (std::size_t t = 0; t < from_.targets.size(); ++t)
      if (auto same = check(from_.targets[t], fmt::format("{}/targets/{}", place_, t)); !same) return same;
    return {};
  }

  Result<void> read_positions() {
    auto numbers = read_accessor(document_, attribute(from_, "POSITION"), place_ + "/attributes/POSITION",
                                 {TINYGLTF_TYPE_VEC3, any_component, "VEC3 of floats, bytes or shorts"});
    if (!numbers) return pass_on(std::move(numbers));
    note_quantization(*numbers, "POSITION");
    to_.positions.reserve(numbers->count());
    for (std::size_t v = 0; v < numbers->count(); ++v) {
      if (!numbers->finite(v)) return bad_input("{}/attributes/POSITION: vertex {} is not finite", place_, v);
      to_.positions.push_back(numbers->vec3(v));
    }
    return {};
  }

  void note_quantization(const Numbers& numbers, std::string_view name) {
    if (numbers.integer && !document_.uses_extension("KHR_mesh_quantization"))
      document_.problem("{}/attributes/{}: whole numbers without KHR_mesh_quantization; read all the same", place_,
                        name);
  }

  Result<void> read_normals() {
    if (auto taken = document_.take_memory(to_.positions.size() * sizeof(Vec3), place_); !taken) return taken;
    const int accessor = attribute(from_, "NORMAL");
    if (accessor < 0) {
      to_.normals = smooth_normals(to_.positions, to_.indices);
      return {};
    }
    auto numbers =
        read_accessor(document_, accessor, place_ + "/attributes/NORMAL",
                      {TINYGLTF_TYPE_VEC3, signed_component, "VEC3 of floats, or of normalized bytes or shorts"});
    if (!numbers) return pass_on(std::move(numbers));
    note_quantization(*numbers, "NORMAL");
    normalise(*numbers);
    return {};
  }

  void normalise(const Numbers& numbers) {
    std::size_t off = 0;
    std::vector<std::size_t> unusable;
    to_.normals.reserve(numbers.count());
    for (std::size_t v = 0; v < numbers.count(); ++v) {
      const Vec3 normal = numbers.vec3(v);
      const double length = glm::length(normal);
      const bool usable = numbers.finite(v) && length > 1e-12;
      to_.normals.push_back(usable ? normal / length : Vec3(0.0));
      if (!usable) unusable.push_back(v);
      off += usable && std::abs(length - 1.0) > numbers.unit_tolerance() ? 1 : 0;
    }
    if (off > 0) document_.problem("{}: {} normals are not of length 1; normalised", place_, off);
    if (unusable.empty()) return;
    const auto computed = smooth_normals(to_.positions, to_.indices);
    for (const std::size_t v : unusable) to_.normals[v] = computed[v];
    document_.problem("{}: {} normals have no direction; computed from the triangles", place_, unusable.size());
  }

  Document& document_;
  const tinygltf::Primitive& from_;
  std::string place_;
  Primitive to_;
};

/// The mesh's morph targets must be the same in all its primitives: the weights belong to the mesh.
Result<void> equalise_targets(Document& document, const std::string& place, const std::vector<std::string>& names,
                              Mesh& mesh) {
  std::size_t most = 0;
  for (const Primitive& primitive : mesh.primitives) most = std::max(most, primitive.morph_targets.size());
  const bool unequal = std::ranges::any_of(
      mesh.primitives, [&](const Primitive& primitive) { return primitive.morph_targets.size() != most; });
  if (unequal)
    document.problem("{}: its primitives have different numbers of morph targets; the missing ones change nothing",
                     place);
  for (Primitive& primitive : mesh.primitives) {
    while (primitive.morph_targets.size() < most) {
      auto target = empty_morph_target(document, place, names, primitive.morph_targets.size());
      if (!target) return pass_on(std::move(target));
      primitive.morph_targets.push_back(std::move(*target));
    }
  }
  return {};
}

Result<void> fit_weights(Document& document, const std::string& place, std::size_t targets,
                         std::vector<double>& weights) {
  if (weights.size() == targets) return {};
  if (auto taken = document.take_memory(targets * sizeof(double), place); !taken) return taken;
  if (!weights.empty())
    document.problem("{}/weights: {} weights for {} morph targets; {}", place, weights.size(), targets,
                     weights.size() > targets ? "the rest are ignored" : "the others are 0");
  weights.resize(targets, 0.0);
  return {};
}

Result<Mesh> read_mesh(Document& document, std::size_t index, const Materials& materials) {
  const tinygltf::Mesh& from = document.gltf.meshes[index];
  const std::string at = fmt::format("meshes/{}", index);
  const auto names = read_target_names(document, index);
  Mesh mesh;
  mesh.name = from.name;
  for (std::size_t p = 0; p < from.primitives.size(); ++p) {
    const std::string place = fmt::format("{}/primitives/{}", at, p);
    if (!is_triangles(from.primitives[p].mode)) {
      document.problem("{}: points or lines; only triangles are read", place);
      continue;
    }
    if (attribute(from.primitives[p], "POSITION") < 0) {
      document.problem("{}: has no POSITION; left out", place);
      continue;
    }
    auto primitive = PrimitiveReader(document, from.primitives[p], place).read(materials, names);
    if (!primitive) return pass_on(std::move(primitive));
    mesh.primitives.push_back(std::move(*primitive));
  }
  if (auto equal = equalise_targets(document, at, names, mesh); !equal) return pass_on(std::move(equal));
  mesh.morph_weights = from.weights;
  const std::size_t targets = mesh.primitives.empty() ? 0 : mesh.primitives[0].morph_targets.size();
  if (auto fitted = fit_weights(document, at, targets, mesh.morph_weights); !fitted) return pass_on(std::move(fitted));
  return mesh;
}

/// The influence with the highest joint number of a mesh: if the skin has that joint, it has all.
struct HighestJoint {
  bool skinned = false;
  bool any = false;
  std::size_t primitive = 0, vertex = 0;
  std::uint32_t joint = 0;
};

HighestJoint highest_joint(const Mesh& mesh) {
  HighestJoint highest;
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
    const Influences& influences = mesh.primitives[p].influences;
    highest.skinned = highest.skinned || influences.vertices() > 0;
    for (std::size_t v = 0; v < influences.vertices(); ++v)
      for (std::size_t e = influences.first[v]; e < influences.first[v + 1]; ++e)
        if (!highest.any || influences.entries[e].joint > highest.joint)
          highest = {true, true, p, v, influences.entries[e].joint};
  }
  return highest;
}

}  // namespace

Result<std::vector<Mesh>> read_meshes(Document& document, const Materials& materials) {
  std::vector<Mesh> meshes;
  for (std::size_t i = 0; i < document.gltf.meshes.size(); ++i) {
    auto mesh = read_mesh(document, i, materials);
    if (!mesh) return pass_on(std::move(mesh));
    meshes.push_back(std::move(*mesh));
  }
  return meshes;
}

Result<void> match_nodes_with_meshes(Document& document, Model& model) {
  std::vector<HighestJoint> highest;
  for (const Mesh& mesh : model.meshes) highest.push_back(highest_joint(mesh));
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    Node& node = model.nodes[n];
    if (node.mesh < 0) continue;
    const auto mesh = static_cast<std::size_t>(node.mesh);
    if (!node.morph_weights.empty())
      if (auto fitted = fit_weights(document, fmt::format("nodes/{}", n), model.meshes[mesh].morph_weights.size(),
                                    node.morph_weights);
          !fitted)
        return fitted;
    if (node.skin < 0) continue;
    const HighestJoint& joint = highest[mesh];
    const std::size_t joints = model.skins[static_cast<std::size_t>(node.skin)].joints.size();
    if (joint.any && joint.joint >= joints)
      return bad_input(
          "nodes/{}: meshes/{}, triangle primitive {}, vertex {} is weighted to joint {}, but skins/{} has {}", n, mesh,
          joint.primitive, joint.vertex, joint.joint, node.skin, joints);
    if (joint.skinned) continue;
    document.problem("nodes/{}: has a skin, but meshes/{} has no weights; it follows the node", n, mesh);
    node.skin = -1;
  }
  return {};
}

}  // namespace sinew::gltf
