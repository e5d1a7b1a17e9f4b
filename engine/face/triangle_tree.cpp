#include "engine/face/triangle_tree.h"

#include <algorithm>
#include <numeric>

namespace sinew {
namespace {

/// Shares of the corners at the place of a triangle that is nearest to p. Ericson, Real-Time Collision
/// Detection, 5.1.5.
Vec3 nearest_shares(const Vec3& p, const std::array<Vec3, 3>& t) {
  const auto& [a, b, c] = t;
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap), d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp),
               d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double sum = va + vb + vc;
  if (!(sum > 0)) return {1, 0, 0};
  return {va / sum, vb / sum, vc / sum};
}

double box_distance2(const Bounds& box, const Vec3& p) {
  const Vec3 d = glm::max(glm::max(box.low - p, p - box.high), Vec3(0.0));
  return glm::dot(d, d);
}

bool box_is_crossed(const Bounds& box, const Vec3& start, const Vec3& direction, double reach) {
  double near = 0.0, far = reach;
  for (int c = 0; c < 3; ++c) {
    if (direction[c] == 0.0) {
      if (start[c] < box.low[c] || start[c] > box.high[c]) return false;
      continue;
    }
    const double a = (box.low[c] - start[c]) / direction[c], b = (box.high[c] - start[c]) / direction[c];
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
  }
  return near <= far;
}

/// Moeller and Trumbore 1997.
std::optional<double> crossing(const Vec3& start, const Vec3& direction, const std::array<Vec3, 3>& t) {
  const Vec3 e1 = t[1] - t[0], e2 = t[2] - t[0], h = glm::cross(direction, e2);
  const double det = glm::dot(e1, h);
  if (std::abs(det) < 1e-14) return {};
  const Vec3 s = start - t[0], q = glm::cross(s, e1);
  const double u = glm::dot(s, h) / det, v = glm::dot(direction, q) / det;
  if (u < 0 || v < 0 || u + v > 1) return {};
  return glm::dot(e2, q) / det;
}

}  // namespace

TriangleTree::TriangleTree(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles)
    : positions_(positions), triangles_(triangles), order_(triangles.size() / 3), centres_(order_.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  for (std::size_t t = 0; t < order_.size(); ++t) {
    const auto c = corners(t);
    centres_[t] = (c[0] + c[1] + c[2]) / 3.0;
  }
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

std::array<Vec3, 3> TriangleTree::corners(std::size_t t) const {
  return {positions_[triangles_[3 * t]], positions_[triangles_[3 * t + 1]], positions_[triangles_[3 * t + 2]]};
}

void TriangleTree::build(std::uint32_t first, std::uint32_t count) {
  constexpr std::uint32_t leaf = 6;
  const std::size_t here = boxes_.size();
  boxes_.emplace_back();
  Bounds bounds, centres;
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (const Vec3& p : corners(order_[i])) bounds.add(p);
    centres.add(centres_[order_[i]]);
  }
  boxes_[here].bounds = bounds;
  if (count <= leaf) {
    boxes_[here].first = first;
    boxes_[here].count = count;
    return;
  }
  const Vec3 size = centres.high - centres.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const auto begin = order_.begin() + first;
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    return centres_[a][axis] != centres_[b][axis] ? centres_[a][axis] < centres_[b][axis] : a < b;
  });
  build(first, half);
  boxes_[here].right = static_cast<std::uint32_t>(boxes_.size());
  build(first + half, count - half);
}

std::optional<SurfacePoint> TriangleTree::nearest(const Vec3& p, double reach, const Filter& filter) const {
  SurfacePoint best;
  best.distance = reach;
  bool found = false;
  std::vector<std::uint32_t> open;
  if (!boxes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    const Box& box = boxes_[at];
    if (box_distance2(box.bounds, p) > best.distance * best.distance) continue;
    for (std::uint32_t i = box.first; i < box.first + box.count; ++i) {
      const std::uint32_t t = order_[i];
      const auto c = corners(t);
      const Vec3 shares = nearest_shares(p, c), place = shares.x * c[0] + shares.y * c[1] + shares.z * c[2];
      const double distance = glm::distance(place, p);
      if (distance > best.distance || (found && distance == best.distance) || !filter(t)) continue;
      best = {t, place, shares, distance};
      found = true;
    }
    if (box.count > 0) continue;
    const bool left_first = box_distance2(boxes_[at + 1].bounds, p) <= box_distance2(boxes_[box.right].bounds, p);
    open.push_back(left_first ? box.right : at + 1);
    open.push_back(left_first ? at + 1 : box.right);
  }
  if (!found) return {};
  return best;
}

std::optional<double> TriangleTree::first_crossing(const Vec3& start, const Vec3& direction, double reach) const {
  std::optional<double> best;
  std::vector<std::uint32_t> open;
  if (!boxes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    const Box& box = boxes_[at];
    if (!box_is_crossed(box.bounds, start, direction, best.value_or(reach))) continue;
    for (std::uint32_t i = box.first; i < box.first + box.count; ++i)
      if (const auto hit = crossing(start, direction, corners(order_[i]));
          hit && *hit > 0 && *hit <= best.value_or(reach))
        best = hit;
    if (box.count > 0) continue;
    open.push_back(box.right);
    open.push_back(at + 1);
  }
  return best;
}

}  // namespace sinew
