#pragma once
/// Nodes, scenes and skins (glTF 2.0 sections 3.5 and 3.7.3).

#include <vector>

#include "engine/core/result.h"
#include "engine/io/gltf_document.h"
#include "engine/model/model.h"

namespace sinew::gltf {

/// All nodes, their hierarchy checked: one parent each, no cycles. A matrix is taken apart into translation, rotation
/// and scale, and kept beside them where they cannot hold it.
Result<std::vector<Node>> read_nodes(Document& document);

/// The root nodes of the scene that is shown: the default one, else the first, else all nodes without a parent.
Result<std::vector<int>> read_roots(Document& document, const std::vector<Node>& nodes);

/// All skins, joints distinct, inverse bind matrices finite (identity where the file has none).
Result<std::vector<Skin>> read_skins(Document& document, const std::vector<Node>& nodes);

/// An affine matrix as translation, rotation and scale (a mirror image as a negative x scale); exact but for shear.
Transform decompose(const Mat4& matrix);

}  // namespace sinew::gltf
