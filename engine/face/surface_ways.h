#pragma once
/// Shortest ways along a mesh's edges. Dijkstra 1959.

#include <cstdint>
#include <vector>

#include "engine/core/math.h"
#include "engine/fit/surface_graph.h"

namespace sinew {

struct SurfaceWay {
  double length;
  std::uint32_t place;
  bool operator>(const SurfaceWay& other) const { return length > other.length; }
};

/// [positions] Lengths of the shortest ways from the seeds, which start with the lengths they are given; infinite where
/// none leads. `before`, where given: the place before each on its way, itself at a seed. No way beyond `longest`.
std::vector<double> surface_ways(const std::vector<Vec3>& positions, const SurfaceGraph& graph,
                                 const std::vector<SurfaceWay>& seeds, double longest = INFINITY,
                                 std::vector<std::uint32_t>* before = nullptr);

}  // namespace sinew
