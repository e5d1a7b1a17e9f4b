#pragma once
/// A posed character's surface as a closed one, cut across its limbs. Girth and volume meters stand on it.
/// engine/definitions.md 10.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/deform/rest_shape.h"
#include "engine/model/character_mesh.h"

namespace sinew {

/// The mesh's triangles with vertices that stand at one place in the rest pose made one: a file splits vertices where
/// texture or normals do, the surface does not end there. [mesh.triangles] each index is that of the first such vertex.
std::vector<std::uint32_t> welded_triangles(const CharacterMesh& mesh, const RestShape& rest);

/// A character in one pose. Positions and joints are in the same space, usually the world.
struct PosedSurface {
  const Model& model;
  const CharacterMesh& mesh;
  std::span<const std::uint32_t> triangles;  ///< welded_triangles()
  std::span<const Vec3> positions;           ///< [vertices]
  std::span<const Mat4> global;              ///< [nodes]
};

/// The closed line in which a plane across a limb cuts the surface round that limb.
struct LimbSection {
  Vec3 place{0.0};             ///< where the plane meets the limb's axis
  Vec3 axis{0.0};              ///< the plane's unit normal: from the limb's joint to its child
  std::vector<Vec3> line;      ///< in order; the last joins the first
  std::uint32_t triangle = 0;  ///< one of the triangles cut, as an index into `triangles` divided by 3
};

/// Cuts the limb from `joint` to `child` at the share `at` of the way, at right angles to it. Of the closed lines in
/// that plane it keeps one that is the limb's: over 60 % of its length on triangles that touch the limb's segment
/// (definitions 6). That leaves out trunk, other limbs and the folded half of the same limb. Of several the one round
/// the axis, outermost first, as a tape lies over what is worn; where none goes round it, the nearest. Fails as
/// bad_input where the joints coincide or there is no such line.
Result<LimbSection> limb_section(const PosedSurface& surface, int joint, int child, double at);

}  // namespace sinew
