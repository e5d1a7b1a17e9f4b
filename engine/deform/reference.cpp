#include "engine/deform/reference.h"

#include <Eigen/Eigenvalues>

#include "engine/deform/character_face.h"
#include "engine/deform/morph.h"
#include "engine/deform/rigid.h"
#include "engine/deform/ssd.h"

namespace sinew {

DeformedVertices deform_reference(const CharacterMesh& mesh, const RestShape& rest, const DeformState& state) {
  const std::size_t vertices = mesh.vertices();
  DeformedVertices out;
  out.positions.resize(vertices);
  out.normals.resize(vertices);
  out.heights.resize(vertices);
  out.blend.resize(vertices);
  MorphedVertices bind = morph(mesh, state.morph_weights);
  std::vector<Vec4> tangents = mesh.tangents;
  if (mesh.face && state.face) CharacterFaceJob{*mesh.face, *state.face, bind.positions, bind.normals, tangents}.run();
  const SkinInput input{bind.positions, bind.normals, state.palette, mesh.influences};
  const SkinOutput output{out.positions, out.normals, out.blend};
  switch (state.deformer) {
    case Deformer::rigid:
      RigidJob{input, output}.run();
      break;
    case Deformer::ssd:
      SsdJob{input, output}.run();
      break;
  }
  for (std::size_t v = 0; v < tangents.size(); ++v) out.tangents.push_back(carry_tangent(out.blend[v], tangents[v]));
  BulgeJob{state.muscles, state.bulge, bind.normals, rest.blend, out.blend,
           out.positions, out.normals, out.heights,  tangents,   out.tangents}
      .run();
  for (std::size_t v = 0; v < out.tangents.size(); ++v)
    out.tangents[v] = tangent_in_plane(out.tangents[v], out.normals[v]);
  return out;
}

bool nearly_singular(const Mat3& blend) {
  const Mat3 squared = glm::transpose(blend) * blend;
  Eigen::Matrix3d symmetric;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) symmetric(i, j) = squared[j][i];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric, Eigen::EigenvaluesOnly);
  constexpr double ratio = 0.05;
  return !(solver.eigenvalues()(0) > ratio * ratio * solver.eigenvalues()(2));
}

}  // namespace sinew
