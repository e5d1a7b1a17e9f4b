#pragma once
#include <span>
#include <vector>

#include "engine/model/character_mesh.h"

namespace sinew {

/// Positions and normals in the bind pose with the morph targets added: v + sum w_t d_t (glTF 2.0, 3.7.2.2).
struct MorphedVertices {
  std::vector<Vec3> positions;  ///< [vertices]
  std::vector<Vec3> normals;    ///< [vertices] not normalised again
};

/// `weights`: [mesh.morph_slots], morph_slot_weights() of the pose.
MorphedVertices morph(const CharacterMesh& mesh, std::span<const double> weights);

}  // namespace sinew
