#pragma once
/// A whole character's vertices in poses, by its weights alone.

#include <span>
#include <vector>

#include "engine/fit/skinned_shape.h"
#include "engine/model/character_mesh.h"

namespace sinew::test {

/// [vertices * poses] vertex after vertex, in the order of `export`; without morphs.
inline std::vector<Vec3> posed_places(const Model& model, const CharacterMesh& mesh, std::span<const Pose> poses) {
  const std::vector<int> order = hierarchy_order(model);
  BonePoses bones(mesh.palette.size(), poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const std::vector<Mat34> palette = palette_transforms(mesh, global_transforms(model, order, poses[k]));
    for (std::size_t b = 0; b < palette.size(); ++b) bones.at(b, k) = palette[b];
  }
  return skinned_places(mesh.positions, mesh.influences, bones);
}

}  // namespace sinew::test
