#pragma once
/// Stanford PLY in: places and polygons alone.

#include <filesystem>

#include "engine/core/files.h"
#include "engine/core/result.h"
#include "engine/model/polygon_mesh.h"

namespace sinew {

/// `x`, `y`, `z` of the element `vertex` and the list `vertex_indices` (or `vertex_index`) of the element `face`,
/// written as text or as bytes in either order; all else is passed over. Turk, *The PLY Polygon File Format*, 1994.
/// Fails as bad_input naming the element and its number.
Result<PolygonMesh> read_ply(const std::filesystem::path& file);

}  // namespace sinew
