#pragma once
/// The head of a body that has no skeleton to name it.

#include <span>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

/// [positions] Which are above the neck's root of a body that stands upright, y up. Its neck is the slice that is
/// narrower than the head above it and the shoulders below it. All of them where there is no body: a head alone, a
/// bust. `triangles`: of the skin, [3 * triangles] indices.
std::vector<bool> above_neck(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles);

}  // namespace sinew
