#pragma once
/// Seams of a mesh closed: vertices that a file has twice because texture or shading changes there.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

/// [positions] A number for each vertex, the same for those that are one place of the surface; `places` counts them.
/// Two borders are a seam where their edges lie on each other and run opposite ways. Where more than two meet, as where
/// lips touch, those are joined whose triangles face most alike, and triangles that face apart never: lips stay two,
/// and lashes that stand on a lid stay a piece of their own. `triangles`: [3 * triangles] indices.
std::vector<std::uint32_t> weld_seams(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles,
                                      std::size_t& places);

}  // namespace sinew
