#pragma once
/// A tape measure.

#include <algorithm>
#include <vector>

#include "engine/model/model.h"

namespace sinew::test {

/// Length of the convex hull of the section at height `y`, of what lies within `reach` of the middle.
inline double tape_girth(const Primitive& skin, double y, double reach) {
  std::vector<Vec2> cut;
  for (std::size_t i = 0; i < skin.indices.size(); i += 3)
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 &a = skin.positions[skin.indices[i + c]], &b = skin.positions[skin.indices[i + (c + 1) % 3]];
      if ((a.y < y) == (b.y < y)) continue;
      const Vec3 p = glm::mix(a, b, (y - a.y) / (b.y - a.y));
      if (std::abs(p.x) < reach) cut.emplace_back(p.x, p.z);
    }
  std::sort(cut.begin(), cut.end(), [](const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  // Andrew's monotone chain: below, then above.
  std::vector<Vec2> hull;
  for (const int round : {0, 1}) {
    const std::size_t start = hull.size();
    for (const Vec2& p : cut) {
      while (hull.size() >= start + 2) {
        const Vec2 u = hull.back() - hull[hull.size() - 2], w = p - hull.back();
        if (u.x * w.y - u.y * w.x > 0.0) break;
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    if (round == 0) std::reverse(cut.begin(), cut.end());
  }
  double length = 0.0;
  for (std::size_t i = 0; i < hull.size(); ++i) length += glm::distance(hull[i], hull[(i + 1) % hull.size()]);
  return length;
}

}  // namespace sinew::test
