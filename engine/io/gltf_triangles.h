#pragma once
/// Triangle lists out of lists, strips and fans, and normals out of triangles.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/math.h"
#include "engine/core/result.h"
#include "engine/io/gltf_document.h"

namespace sinew::gltf {

/// Three indices a triangle, all below `vertices`; for a primitive without indices its vertices in order. The
/// primitive's mode is one of the three triangle modes.
Result<std::vector<std::uint32_t>> read_triangles(Document& document, const tinygltf::Primitive& primitive,
                                                  const std::string& place, std::size_t vertices);

/// Smooth normals: for each vertex the sum of the cross products of its triangles, so that large triangles count for
/// more. Vertices without any area point along +Z.
std::vector<Vec3> smooth_normals(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles);

}  // namespace sinew::gltf
