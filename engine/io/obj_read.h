#pragma once
/// Wavefront OBJ in: places and polygons alone.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/core/math.h"
#include "engine/core/result.h"

namespace sinew {

struct ObjMesh {
  std::vector<Vec3> positions;
  std::vector<std::vector<std::uint32_t>> polygons;  ///< three corners and more, all below positions.size()
};

/// The lines `v` and `f` of a file, negative indices counted from the end; all else is passed over. Fails as bad_input
/// with the line's number.
Result<ObjMesh> read_obj(const std::filesystem::path& file);

}  // namespace sinew
