#pragma once
#include <span>
#include <vector>

#include "engine/model/character_mesh.h"
#include "engine/rig/pose.h"

namespace sinew {

/// Rest space: the character as its nodes' own rest pose shows it, model units and axes. Muscles are defined here
/// (engine/definitions.md 6).
struct RestShape {
  std::vector<Vec3> positions;  ///< [vertices]
  std::vector<Vec3> normals;    ///< [vertices] unit length
  std::vector<Mat3> blend;      ///< [vertices] A0: the 3x3 of the blended matrix at rest
  std::vector<Mat4> global;     ///< [nodes] rest global transforms
};

/// `order` is hierarchy_order(model).
RestShape rest_shape(const Model& model, const CharacterMesh& mesh, std::span<const int> order);

}  // namespace sinew
