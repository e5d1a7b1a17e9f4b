#pragma once
/// What a camera sees, as a solid. No Vulkan here.

#include <array>
#include <span>
#include <vector>

#include "engine/render/viewpoint.h"

namespace sinew {

/// The part of space between a camera's near and far planes that its picture shows.
struct Frustum {
  std::array<Vec3, 8> corners;  ///< bit 0: right, bit 1: low (as in clip space), bit 2: far
  std::array<Vec4, 6> planes;   ///< dot(plane, (p, 1)) >= 0 within: near, far, and the four sides
};

Frustum frustum_of(const Viewpoint& viewpoint, double aspect);

/// What of a convex polygon lies within, its corners in order; fewer than three: nothing.
std::vector<Vec3> clipped_polygon(std::vector<Vec3> polygon, std::span<const Vec4> planes);

/// Points whose convex hull is what the frustum and the box share; none where they are apart.
std::vector<Vec3> seen_part(const Frustum& frustum, const Bounds& box);

}  // namespace sinew
