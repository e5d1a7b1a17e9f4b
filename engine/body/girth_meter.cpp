#include "engine/body/girth_meter.h"

#include <algorithm>

namespace sinew {
namespace {

double closed_length(std::span<const Vec2> points) {
  double length = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) length += glm::distance(points[i], points[(i + 1) % points.size()]);
  return length;
}

bool turns_left(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0.0;
}

/// Andrew's monotone chain: lower half, then upper half.
std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Vec2> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t begin = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= begin + 2 && !turns_left(hull[hull.size() - 2], hull.back(), p)) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The section's line in its own plane.
std::vector<Vec2> flat(const LimbSection& section) {
  const Vec3 other = std::abs(section.axis.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  const Vec3 u = glm::normalize(glm::cross(section.axis, other)), v = glm::cross(section.axis, u);
  std::vector<Vec2> points;
  for (const Vec3& p : section.line)
    points.emplace_back(glm::dot(p - section.place, u), glm::dot(p - section.place, v));
  return points;
}

}  // namespace

Girth section_girth(const LimbSection& section) {
  const std::vector<Vec2> points = flat(section);
  return {closed_length(points), closed_length(convex_hull(points))};
}

Result<Girth> limb_girth(const PosedSurface& surface, int joint, int child, double at) {
  auto section = limb_section(surface, joint, child, at);
  if (!section) return pass_on(std::move(section));
  return section_girth(*section);
}

}  // namespace sinew
