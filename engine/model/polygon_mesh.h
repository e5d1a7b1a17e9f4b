#pragma once
/// Places and polygons alone, as simple mesh files hold them.

#include <cstdint>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

struct PolygonMesh {
  std::vector<Vec3> positions;
  std::vector<std::vector<std::uint32_t>> polygons;  ///< three corners and more, all below positions.size()
};

}  // namespace sinew
