#pragma once
/// The rigid skin as a picture needs it: each triangle follows one bone, so that gaps open at the joints
/// (engine/definitions.md 2).

#include <cstdint>
#include <vector>

#include "engine/model/character_mesh.h"

namespace sinew {

/// A copy of a vertex that follows another joint than the vertex itself.
struct RigidDuplicate {
  std::uint32_t vertex = 0;
  std::uint32_t joint = 0;  ///< palette index
};

struct RigidSplit {
  std::vector<RigidDuplicate> duplicates;  ///< numbered after the mesh's own vertices
  std::vector<std::uint32_t> triangles;    ///< in the order of the mesh's
};

/// Gives each triangle the bone that most of its corners follow (of three different ones the first corner's) and a copy
/// of every corner that follows another.
RigidSplit split_by_bone(const CharacterMesh& mesh);

}  // namespace sinew
