#include "engine/app/describe.h"
#include "engine/fit/weight_run.h"

#include <set>

namespace sinew {
namespace {

std::size_t distinct_joints(const Model& model) {
  std::set<int> nodes;
  for (const Skin& skin : model.skins) nodes.insert(skin.joints.begin(), skin.joints.end());
  return nodes.size();
}

/// Of the file's vertices: one that follows its mesh's node has no weights.
std::size_t most_influences(const Model& model) {
  std::size_t most = 0;
  for (const Mesh& mesh : model.meshes)
    for (const Primitive& primitive : mesh.primitives) most = std::max(most, most_influences(primitive.influences));
  return most;
}

std::size_t morph_target_count(const Model& model) {
  std::size_t sum = 0;
  for (const Mesh& mesh : model.meshes)
    if (!mesh.primitives.empty()) sum += mesh.primitives.front().morph_targets.size();
  return sum;
}

}  // namespace

Description describe(const Stage& stage) {
  Description d;
  d.vertices = stage.vertices();
  d.triangles = stage.triangles();
  for (const StagedCharacter& character : stage.characters) {
    d.joints += distinct_joints(*character.model);
    d.max_influences = std::max(d.max_influences, most_influences(*character.model));
    d.morph_targets += morph_target_count(*character.model);
  }
  d.bounds = rest_bounds(stage);
  return d;
}

}  // namespace sinew
