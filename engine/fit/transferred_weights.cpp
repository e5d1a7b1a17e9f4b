#include "engine/fit/transferred_weights.h"

#include <map>
#include <set>

#include "engine/core/parallel.h"
#include "engine/fit/closest_surface.h"
#include "engine/fit/skinned_shape.h"
#include "engine/fit/weight_run.h"
#include "engine/io/gltf_read.h"

namespace sinew {
namespace {

/// All skinned meshes of a model as one; influences name nodes.
SkinnedShape joined_shapes(const Model& model) {
  SkinnedShape all;
  for (const SkinnedShape& shape : skinned_shapes(model)) {
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), shape.positions.begin(), shape.positions.end());
    for (const std::uint32_t index : shape.triangles) all.triangles.push_back(first + index);
    for (std::size_t v = 0; v < shape.positions.size(); ++v) {
      const auto own = influences_of(shape.influences, v);
      std::vector<Influence> run(own.begin(), own.end());
      for (Influence& influence : run)
        influence.joint = static_cast<std::uint32_t>(model.skins[shape.skin].joints[influence.joint]);
      all.influences.add_vertex(run);
    }
  }
  return all;
}

/// The joint of a skin that stands for each node of another model, [nodes], -1: none.
std::vector<int> joints_for_nodes(const Model& other, const Model& model, const Skin& skin) {
  std::map<std::string, int> names;
  for (std::size_t j = 0; j < skin.joints.size(); ++j)
    names.emplace(model.nodes[skin.joints[j]].name, static_cast<int>(j));
  std::vector<int> joints;
  for (const Node& node : other.nodes) {
    const Node* at = &node;
    auto found = names.find(at->name);
    while (found == names.end() && at->parent >= 0) {
      at = &other.nodes[at->parent];
      found = names.find(at->name);
    }
    joints.push_back(found == names.end() ? -1 : found->second);
  }
  return joints;
}

Influences taken_over(const SkinnedShape& from, const ClosestSurface& surface, const std::vector<int>& joints,
                      const std::vector<Vec3>& positions) {
  std::vector<std::vector<Influence>> runs(positions.size());
  parallel_for(
      positions.size(),
      [&](std::size_t v) {
        const SurfacePoint point = surface.find(positions[v]);
        Mixture mixture;
        for (int c = 0; c < 3; ++c)
          for (const Influence& influence : influences_of(from.influences, point.vertex[c]))
            if (const int joint = joints[influence.joint]; joint >= 0) {
              const Influence meant{static_cast<std::uint32_t>(joint), influence.weight};
              mixture.add({&meant, 1}, point.share[c]);
            }
        if (auto weights = mixture.list(); !weights.empty()) runs[v] = weight_run(std::move(weights), max_influences);
      },
      256);
  return gathered(runs);
}

}  // namespace

Result<std::vector<std::string>> transfer_weights(const Model& other, Model& model) {
  const SkinnedShape from = joined_shapes(other);
  if (from.triangles.empty()) return bad_input("{}: nothing in it is skinned; expected weights to take", other.file);
  const std::vector<SkinnedShape> shapes = skinned_shapes(model);
  if (shapes.empty()) return bad_input("{}: nothing in it is skinned; expected a mesh with a skeleton", model.file);
  const ClosestSurface surface(from.positions, from.triangles);
  std::set<std::uint32_t> used;
  for (const Influence& influence : from.influences.entries) used.insert(influence.joint);
  std::set<std::string> missing;
  for (const SkinnedShape& shape : shapes) {
    const Skin& skin = model.skins[shape.skin];
    const std::vector<int> joints = joints_for_nodes(other, model, skin);
    bool any = false;
    for (const std::uint32_t node : used) {
      any = any || joints[node] >= 0;
      if (joints[node] < 0 || model.nodes[skin.joints[joints[node]]].name != other.nodes[node].name)
        missing.insert(other.nodes[node].name);
    }
    if (!any) return bad_input("{}: none of its joints has the name of one in {}", model.file, other.file);
    set_influences(shape, taken_over(from, surface, joints, shape.positions), model);
  }
  return std::vector<std::string>(missing.begin(), missing.end());
}

Result<void> take_weights(const std::string& file, Model& model, std::vector<std::string>& problems) {
  const auto other = read_gltf(file);
  if (!other) return tl::unexpected<Error>(other.error());
  const auto missing = transfer_weights(*other, model);
  if (!missing) return tl::unexpected<Error>(missing.error());
  if (!missing->empty())
    problems.push_back(fmt::format("{} joints of {} are not in the skeleton; joints above them take their weights: {}",
                                   missing->size(), file, fmt::join(*missing, ", ")));
  return {};
}

}  // namespace sinew
