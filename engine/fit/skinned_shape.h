#pragma once
/// All meshes of a model that follow one skin, as one run of vertices.

#include <string>
#include <vector>

#include "engine/fit/bone_poses.h"
#include "engine/model/model.h"
#include "engine/rig/pose.h"

namespace sinew {

/// Where a primitive's vertices stand in a SkinnedShape.
struct ShapePart {
  int mesh = -1;
  std::size_t primitive = 0, first = 0, count = 0;
};

struct SkinnedShape {
  int skin = -1;
  std::vector<ShapePart> parts;
  std::vector<Vec3> positions;           ///< [vertices] bind shape, without morphs
  std::vector<std::uint32_t> triangles;  ///< three vertex indices a triangle
  Influences influences;                 ///< [vertices] joints of the skin
  /// The part in which a vertex stands.
  const ShapePart& part_of(std::size_t vertex) const;
};

/// One a skin that the scene draws, in the scene's order. A mesh that several nodes draw stands once, with the skin of
/// the first; unskinned primitives are left out.
std::vector<SkinnedShape> skinned_shapes(const Model& model);

/// Final transforms of the skin's joints in these poses.
BonePoses bone_poses(const Model& model, int skin, std::span<const Pose> poses);

/// Places of a shape's vertices in all poses by linear blend skinning, [vertices * poses], vertex after vertex.
std::vector<Vec3> skinned_places(std::span<const Vec3> positions, const Influences& influences, const BonePoses& bones);

/// Puts weights of a shape's vertices back into the model's primitives.
void set_influences(const SkinnedShape& shape, const Influences& influences, Model& model);

}  // namespace sinew
