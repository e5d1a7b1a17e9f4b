#pragma once
/// The CPU's deformation of a whole character in double precision: what the compute pass is measured against.

#include <span>
#include <vector>

#include "engine/deform/bulge.h"
#include "engine/deform/face.h"
#include "engine/deform/rest_shape.h"

namespace sinew {

/// One pose of one character, as both deformers take it.
struct DeformState {
  std::span<const Mat34> palette;         ///< [mesh.palette] F_i, world space
  std::span<const double> morph_weights;  ///< [mesh.morph_slots]
  std::span<const ActiveMuscle> muscles;
  Deformer deformer = Deformer::ssd;
  BulgeMode bulge = BulgeMode::on;
  const FaceState* face = nullptr;  ///< of a mesh that has a face; null: at rest
};

struct DeformedVertices {
  std::vector<Vec3> positions;  ///< [vertices] world space
  std::vector<Vec3> normals;    ///< [vertices] unit length
  std::vector<double> heights;  ///< [vertices] how far a muscle lifted each one
  std::vector<Mat3> blend;      ///< [vertices] the 3x3 that carried each one
  std::vector<Vec4> tangents;   ///< [vertices] unit length, w: side of the bitangent; or empty: the mesh has none
};

/// Morph targets, then face, then skin, then bulge.
DeformedVertices deform_reference(const CharacterMesh& mesh, const RestShape& rest, const DeformState& state);

/// True where the smallest singular value of a blended matrix is under 0.05 of its largest: there a normal's direction
/// is ill-conditioned and a comparison of normals allows more.
bool nearly_singular(const Mat3& blend);

}  // namespace sinew
