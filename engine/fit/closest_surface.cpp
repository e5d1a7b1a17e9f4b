#include "engine/fit/closest_surface.h"

#include <numeric>

namespace sinew {
namespace {

constexpr std::uint32_t leaf = 4;  ///< triangles

double squared_distance_to(const Bounds& box, const Vec3& p) {
  const Vec3 off = glm::max(glm::max(box.low - p, p - box.high), Vec3(0.0));
  return glm::dot(off, off);
}

/// Barycentric coordinates of the point of a triangle nearest to p. Ericson, *Real-Time Collision Detection*, 5.1.5.
std::array<double, 3> nearest_shares(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {1.0 - d1 / (d1 - d3), d1 / (d1 - d3), 0.0};
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {1.0 - d2 / (d2 - d6), 0.0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4, e = d4 - d3, f = d5 - d6;
  if (va <= 0.0 && e >= 0.0 && f >= 0.0) return {0.0, f / (e + f), e / (e + f)};
  const double all = va + vb + vc;
  return {va / all, vb / all, vc / all};
}

}  // namespace

ClosestSurface::ClosestSurface(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles)
    : positions_(positions), triangles_(triangles), order_(triangles.size() / 3) {
  std::iota(order_.begin(), order_.end(), 0u);
  boxes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(order_.size()));
}

void ClosestSurface::build(std::uint32_t box, std::uint32_t first, std::uint32_t count) {
  const auto middle = [&](std::uint32_t t) {
    return positions_[triangles_[3 * t]] + positions_[triangles_[3 * t + 1]] + positions_[triangles_[3 * t + 2]];
  };
  Bounds bounds, middles;
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (int c = 0; c < 3; ++c) bounds.add(positions_[triangles_[3 * order_[i] + c]]);
    middles.add(middle(order_[i]));
  }
  boxes_[box].bounds = bounds;
  boxes_[box].first = first;
  if (count <= leaf) {
    boxes_[box].count = count;
    return;
  }
  const Vec3 size = middles.high - middles.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t half = count / 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    const double x = middle(a)[axis], y = middle(b)[axis];
    return x != y ? x < y : a < b;
  });
  const auto left = static_cast<std::uint32_t>(boxes_.size());
  boxes_[box].left = left;
  boxes_.resize(boxes_.size() + 2);
  build(left, first, half);
  build(left + 1, first + half, count - half);
}

void ClosestSurface::visit(std::uint32_t box, const Vec3& p, SurfacePoint& best, std::uint32_t& triangle) const {
  const Box& at = boxes_[box];
  if (at.count == 0 && at.left != 0) {
    const double left = squared_distance_to(boxes_[at.left].bounds, p);
    const double right = squared_distance_to(boxes_[at.left + 1].bounds, p);
    const bool right_first = right < left;
    for (int i = 0; i < 2; ++i) {
      const bool go_right = (i == 0) == right_first;
      if ((go_right ? right : left) <= best.distance * best.distance)
        visit(at.left + (go_right ? 1 : 0), p, best, triangle);
    }
    return;
  }
  for (std::uint32_t i = at.first; i < at.first + at.count; ++i) {
    const std::uint32_t* corner = &triangles_[3 * order_[i]];
    const Vec3 &a = positions_[corner[0]], &b = positions_[corner[1]], &c = positions_[corner[2]];
    const std::array<double, 3> share = nearest_shares(p, a, b, c);
    const double distance = glm::length(share[0] * a + share[1] * b + share[2] * c - p);
    if (distance > best.distance || (distance == best.distance && order_[i] > triangle)) continue;
    best = {{corner[0], corner[1], corner[2]}, share, distance};
    triangle = order_[i];
  }
}

SurfacePoint ClosestSurface::find(const Vec3& p) const {
  SurfacePoint best;
  std::uint32_t triangle = ~0u;
  visit(0, p, best, triangle);
  return best;
}

}  // namespace sinew
