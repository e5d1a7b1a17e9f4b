#pragma once
/// What a primitive's vertices carry for its material: texture coordinates, tangents, colours (glTF 2.0
/// section 3.7.2.1).

#include <string>

#include "engine/core/result.h"
#include "engine/io/gltf_document.h"
#include "engine/io/gltf_material.h"

namespace sinew::gltf {

/// Fills `to`, whose positions and normals are there. Tangents are read where the material has a normal texture only.
/// Numbers that are not finite are mended and noted; fails where an accessor has another format.
Result<void> read_surface(Document& document, const tinygltf::Primitive& from, const std::string& place,
                          const Materials& materials, Primitive& to);

}  // namespace sinew::gltf
