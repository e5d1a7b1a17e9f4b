#include "engine/deform/rest_shape.h"

#include "engine/deform/morph.h"
#include "engine/deform/ssd.h"

namespace sinew {

RestShape rest_shape(const Model& model, const CharacterMesh& mesh, std::span<const int> order) {
  const Pose pose = rest_pose(model);
  RestShape rest;
  rest.global = global_transforms(model, order, pose);
  rest.positions.resize(mesh.vertices());
  rest.normals.resize(mesh.vertices());
  rest.blend.resize(mesh.vertices());
  const MorphedVertices bind = morph(mesh, morph_slot_weights(mesh, pose));
  const std::vector<Mat34> palette = palette_transforms(mesh, rest.global);
  SsdJob{{bind.positions, bind.normals, palette, mesh.influences}, {rest.positions, rest.normals, rest.blend}}.run();
  return rest;
}

}  // namespace sinew
