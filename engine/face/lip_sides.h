#pragma once
/// Which side of the mouth a place of a skin is on: by the way along the skin, since lips that touch are near in space.

#include <cstdint>
#include <vector>

#include "engine/face/landmarks.h"
#include "engine/fit/surface_graph.h"

namespace sinew {

/// [places] 1 upper, -1 lower, 0 far from the mouth or as near to both. `marks`: drawing units, lipContact among them.
std::vector<std::int8_t> lip_sides(const std::vector<Vec3>& positions, const std::vector<Vec3>& normals,
                                   const SurfaceGraph& graph, const std::vector<bool>& skin, const Landmarks& marks);

}  // namespace sinew
