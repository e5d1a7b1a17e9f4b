#pragma once
/// Vertices of a mesh grouped by how they move.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/fit/bone_poses.h"

namespace sinew {

/// Examples of how a mesh moves.
struct MovingMesh {
  std::span<const Vec3> rest;   ///< [vertices]
  std::span<const Vec3> posed;  ///< [vertices * poses] vertex after vertex
  std::size_t poses = 0;

  std::size_t vertices() const { return rest.size(); }
  /// Sum over the poses of the squared distance to where a bone alone takes a vertex.
  double error(std::size_t vertex, const BonePoses& bones, std::size_t bone) const;
  double diagonal() const;  ///< of the rest mesh's box
};

/// Rigid transforms of `count` groups that move as one each. Linde, Buzo and Gray 1980: the groups that fit worst are
/// split at the vertex that fits worst and lies far out, then vertices go to the bone that carries them best, in turn
/// with the bones' transforms. Fails as bad_input where fewer motions are to be told apart; as interrupted.
Result<BonePoses> clustered_motions(const MovingMesh& mesh, std::size_t count);

/// The transforms of `bone` that carry `vertex` and the `patch` vertices nearest to it at rest.
void start_bone(const MovingMesh& mesh, std::size_t vertex, std::size_t bone, BonePoses& bones);

}  // namespace sinew
