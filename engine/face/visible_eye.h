#pragma once
/// Eyes found by their balls and by how much of them the lids leave to be seen.

#include <vector>

#include "engine/face/landmarks.h"
#include "engine/face/triangle_tree.h"

namespace sinew {

/// Corners and lid edges of both eyes, by landmark name; empty where no two balls of one size lie on either side of the
/// middle. `others`: triangles that are not the skin's. All in the head's own axes; `unit`: a drawing unit.
Landmarks find_visible_eyes(const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& others,
                            const TriangleTree& skin, double middle, const Vec3& nose_tip, double unit);

}  // namespace sinew
