#pragma once
/// How a model's nodes, skins and meshes stand in a written rig: where they stood, as far as glTF 2.0 lets them.
///
/// Three rules of glTF move things. A skinned mesh ignores its node's transform, so its node has to be an identity root
/// (Specification 3.7.3.2); a vertex without influences, which follows the node in a Model, needs a joint for that. The
/// joints of a skin need a common root. A local matrix with shear is not allowed at all; it is written as a chain of
/// nodes that multiply to it. The deformed vertices stay the same throughout.

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace sinew {

/// One node to write; `mesh` is an index into RigLayout::meshes.
struct RigNode {
  std::string name;
  Transform rest{};
  std::vector<int> children{};
  int mesh = -1;
  int skin = -1;
  std::vector<double> morph_weights{};
};

/// One mesh to write. A mesh of the model stands twice where some of its nodes skin it and some do not.
struct RigMesh {
  int source = -1;  ///< index into Model::meshes
  bool skinned = false;
  int follow_joint = -1;  ///< joint of the vertices that have no influences, -1 where all have some

  auto operator<=>(const RigMesh&) const = default;
};

struct RigLayout {
  std::vector<RigNode> nodes;  ///< the model's nodes under their own indices, then those that were added
  std::vector<int> roots;      ///< of the scene
  std::vector<Skin> skins;     ///< the model's, in its order, with the joints that were added at the end of their lists
  std::vector<RigMesh> meshes;    ///< in the order of the model's meshes; what the scene does not show is left out
  std::vector<int> moved_node;    ///< [model nodes] the node that a translation or rotation channel moves
  std::vector<int> drawing_node;  ///< [model nodes] the node that draws the mesh and has its weights, or -1
};

/// True where the primitive has something to draw. glTF has no empty arrays, so the others are left out of a file.
bool has_triangles(const Primitive& primitive);

RigLayout rig_layout(const Model& model);

}  // namespace sinew
