#pragma once
/// Meshes: triangles with positions, normals, what their material asks of the vertices, skin weights and morph targets
/// (glTF 2.0 section 3.7).

#include <vector>

#include "engine/core/result.h"
#include "engine/io/gltf_document.h"
#include "engine/io/gltf_material.h"
#include "engine/model/model.h"

namespace sinew::gltf {

/// All meshes. Primitives that are no triangles or have no positions are left out and noted; the materials say
/// which texture coordinates each wants.
Result<std::vector<Mesh>> read_meshes(Document& document, const Materials& materials);

/// Compares every mesh with the skins and morph weights of the nodes that draw it. Fails where a weight names a joint
/// that the skin does not have; takes the skin from nodes whose mesh has no weights.
Result<void> match_nodes_with_meshes(Document& document, Model& model);

}  // namespace sinew::gltf
