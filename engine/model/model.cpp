#include "engine/model/model.h"

namespace sinew {

Model single_mesh_model(Mesh mesh) {
  Model model;
  Node& node = model.nodes.emplace_back();
  node.name = mesh.name;
  node.mesh = 0;
  model.roots = {0};
  model.meshes.push_back(std::move(mesh));
  return model;
}

}  // namespace sinew
