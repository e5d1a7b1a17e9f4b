#include "engine/face/surface_ways.h"

#include <queue>

namespace sinew {

std::vector<double> surface_ways(const std::vector<Vec3>& positions, const SurfaceGraph& graph,
                                 const std::vector<SurfaceWay>& seeds, double longest,
                                 std::vector<std::uint32_t>* before) {
  std::vector<double> out(positions.size(), INFINITY);
  if (before) before->resize(positions.size());
  std::priority_queue<SurfaceWay, std::vector<SurfaceWay>, std::greater<>> open;
  for (const SurfaceWay& seed : seeds)
    if (seed.length < out[seed.place]) {
      out[seed.place] = seed.length;
      if (before) (*before)[seed.place] = seed.place;
      open.push(seed);
    }
  while (!open.empty()) {
    const SurfaceWay here = open.top();
    open.pop();
    if (here.length > out[here.place]) continue;
    for (const std::uint32_t next : graph.of(here.place)) {
      const double length = here.length + glm::distance(positions[here.place], positions[next]);
      if (length >= out[next] || length > longest) continue;
      out[next] = length;
      if (before) (*before)[next] = here.place;
      open.push({length, next});
    }
  }
  return out;
}

}  // namespace sinew
