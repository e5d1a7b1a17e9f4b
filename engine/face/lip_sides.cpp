#include "engine/face/lip_sides.h"

#include "engine/face/surface_ways.h"

namespace sinew {

std::vector<std::int8_t> lip_sides(const std::vector<Vec3>& positions, const std::vector<Vec3>& normals,
                                   const SurfaceGraph& graph, const std::vector<bool>& skin, const Landmarks& marks) {
  constexpr double undecided = 0.05, most_turned = 0.35;
  const Vec3 contact = marks.at("lipContact");
  const double width = glm::distance(marks.at("lipCornerLeft"), marks.at("lipCornerRight"));
  // `facing`: 1 where the place must not face up: the upper lip's edge looks down; -1 the other way; 0 either.
  const auto seed = [&](const char* name, double facing, std::vector<SurfaceWay>& out) {
    const auto mark = marks.find(name);
    if (mark == marks.end()) return;
    double nearest = INFINITY;
    std::uint32_t best = 0;
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
      if (!skin[v] || facing * normals[v].y > most_turned) continue;
      const double d = glm::distance(positions[v], mark->second);
      if (d < nearest) nearest = d, best = v;
    }
    // As if all ways started at the line where the lips meet.
    if (std::isfinite(nearest)) out.push_back({-glm::distance(mark->second, contact), best});
  };
  std::vector<SurfaceWay> upper, lower;
  for (const char* name : {"noseBase", "lipTop"}) seed(name, 0.0, upper);
  for (const char* name : {"upperLip", "upperLipSideLeft", "upperLipSideRight"}) seed(name, 1.0, upper);
  for (const char* name : {"chin", "lipBottom"}) seed(name, 0.0, lower);
  for (const char* name : {"lowerLip", "lowerLipSideLeft", "lowerLipSideRight"}) seed(name, -1.0, lower);
  const std::vector<double> to_upper = surface_ways(positions, graph, upper),
                            to_lower = surface_ways(positions, graph, lower);
  std::vector<std::int8_t> out(positions.size(), 0);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!skin[v] || glm::distance(positions[v], contact) > 0.9 * width) continue;
    const double more = to_lower[v] - to_upper[v];
    if (std::isfinite(more) && std::abs(more) > undecided) out[v] = more > 0 ? 1 : -1;
  }
  return out;
}

}  // namespace sinew
