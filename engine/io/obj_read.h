#pragma once
/// Wavefront OBJ in: places and polygons alone.

#include <filesystem>

#include "engine/core/result.h"
#include "engine/model/polygon_mesh.h"

namespace sinew {

/// The lines `v` and `f` of a file, negative indices counted from the end; all else is passed over. Fails as bad_input
/// with the line's number.
Result<PolygonMesh> read_obj(const std::filesystem::path& file);

}  // namespace sinew
