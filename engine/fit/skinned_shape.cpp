#include "engine/fit/skinned_shape.h"

#include <algorithm>
#include <set>

#include "engine/core/parallel.h"
#include "engine/model/character_mesh.h"

namespace sinew {
namespace {

void append(const Primitive& primitive, ShapePart part, SkinnedShape& shape) {
  part.first = shape.positions.size();
  part.count = primitive.positions.size();
  shape.parts.push_back(part);
  shape.positions.insert(shape.positions.end(), primitive.positions.begin(), primitive.positions.end());
  for (const std::uint32_t index : primitive.indices)
    shape.triangles.push_back(static_cast<std::uint32_t>(part.first) + index);
  const Influences& source = primitive.influences;
  for (std::size_t v = 0; v < part.count; ++v)
    shape.influences.add_vertex(
        {source.entries.begin() + source.first[v], source.entries.begin() + source.first[v + 1]});
}

}  // namespace

const ShapePart& SkinnedShape::part_of(std::size_t vertex) const {
  const auto after = std::upper_bound(parts.begin(), parts.end(), vertex,
                                      [](std::size_t v, const ShapePart& part) { return v < part.first; });
  return *(after - 1);
}

std::vector<SkinnedShape> skinned_shapes(const Model& model) {
  std::vector<SkinnedShape> shapes;
  std::set<int> seen;
  for (const int index : hierarchy_order(model)) {
    const Node& node = model.nodes[index];
    if (node.mesh < 0 || node.skin < 0 || !seen.insert(node.mesh).second) continue;
    auto shape = std::find_if(shapes.begin(), shapes.end(), [&](const auto& s) { return s.skin == node.skin; });
    if (shape == shapes.end()) {
      shapes.emplace_back().skin = node.skin;
      shape = shapes.end() - 1;
    }
    const std::vector<Primitive>& primitives = model.meshes[node.mesh].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i)
      if (!primitives[i].positions.empty() && primitives[i].influences.vertices() == primitives[i].positions.size())
        append(primitives[i], {node.mesh, i}, *shape);
  }
  std::erase_if(shapes, [](const SkinnedShape& shape) { return shape.positions.empty(); });
  return shapes;
}

BonePoses bone_poses(const Model& model, int skin, std::span<const Pose> poses) {
  const std::vector<int> order = hierarchy_order(model);
  const Skin& source = model.skins[skin];
  BonePoses bones(source.joints.size(), poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const std::vector<Mat4> global = global_transforms(model, order, poses[k]);
    for (std::size_t b = 0; b < source.joints.size(); ++b)
      bones.at(b, k) = Mat34::from(global[source.joints[b]] * source.inverse_bind[b]);
  }
  return bones;
}

std::vector<Vec3> skinned_places(std::span<const Vec3> positions, const Influences& influences,
                                 const BonePoses& bones) {
  std::vector<Vec3> places(positions.size() * bones.poses);
  parallel_for(positions.size(), [&](std::size_t v) {
    // A vertex without weights follows its mesh's node, which a skin's mesh ignores: it stays.
    const bool free = influences.first[v] == influences.first[v + 1];
    for (std::size_t k = 0; k < bones.poses; ++k) {
      Vec3& place = places[v * bones.poses + k];
      if (free) place = positions[v];
      for (std::uint32_t i = influences.first[v]; i < influences.first[v + 1]; ++i) {
        const Influence& influence = influences.entries[i];
        place += influence.weight * bones.at(influence.joint, k).transform_point(positions[v]);
      }
    }
  });
  return places;
}

void set_influences(const SkinnedShape& shape, const Influences& influences, Model& model) {
  for (const ShapePart& part : shape.parts) {
    Influences& target = model.meshes[part.mesh].primitives[part.primitive].influences;
    target = {};
    for (std::size_t v = part.first; v < part.first + part.count; ++v)
      target.add_vertex(
          {influences.entries.begin() + influences.first[v], influences.entries.begin() + influences.first[v + 1]});
  }
}

}  // namespace sinew
