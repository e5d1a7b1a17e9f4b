#pragma once
/// A deformed mesh as it leaves the program: what `export` writes.

#include <cstdint>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

/// One pose's vertices, world space.
struct BakedFrame {
  std::vector<Vec3f> positions;  ///< [vertices]
  std::vector<Vec3f> normals;    ///< [vertices] unit length
};

/// One or more frames of the same triangles.
struct BakedMesh {
  std::vector<BakedFrame> frames;          ///< at least one
  std::vector<double> times;               ///< [frames] seconds, rising
  std::vector<std::uint32_t> triangles;    ///< three indices a triangle
  std::vector<Vec2f> texture_coordinates;  ///< [vertices], or empty
};

}  // namespace sinew
