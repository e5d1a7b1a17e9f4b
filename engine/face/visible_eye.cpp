#include "engine/face/visible_eye.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "engine/face/fitted_ball.h"
#include "engine/fit/surface_graph.h"

namespace sinew {
namespace {

std::vector<FittedBall> balls(const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& triangles,
                              const Vec3& nose, double unit) {
  constexpr double most_error = 0.10, smallest = 0.15, largest = 0.6;
  const SurfaceGraph graph = surface_graph(positions, triangles);
  std::map<std::uint32_t, std::set<std::uint32_t>> shells;
  for (const std::uint32_t v : triangles) shells[graph.shell[v]].insert(v);
  std::vector<FittedBall> out;
  for (const auto& [shell, vertices] : shells) {
    std::vector<Vec3> points;
    Bounds box;
    for (const std::uint32_t v : vertices) {
      points.push_back(positions[v]);
      box.add(positions[v]);
    }
    const Vec3 size = box.high - box.low;
    if (points.size() < 12 || std::max({size.x, size.y, size.z}) > 3 * largest * unit) continue;
    const FittedBall ball = fitted_ball(points);
    const bool round = std::min({size.x, size.y, size.z}) > ball.radius;
    const bool here =
        ball.centre.y > nose.y && ball.centre.y < nose.y + 1.6 * unit && ball.centre.z > nose.z - 2.0 * unit;
    if (round && here && ball.error < most_error && ball.radius > smallest * unit && ball.radius < largest * unit)
      out.push_back(ball);
  }
  return out;
}

/// What is seen of the ball from straight ahead: directions from its centre that no lid covers, joined to the middle.
struct Opening {
  Vec3 inner, outer, upper, lower;
};

std::optional<Opening> opening(const FittedBall& ball, const TriangleTree& skin, double outward) {
  constexpr int half = 40;  // steps of 2 degrees to each side
  constexpr double step = 2.0 * degrees_to_radians;
  const auto direction = [&](int i, int j) {
    const double a = i * step * outward, e = j * step;
    return Vec3(std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e));
  };
  const auto free = [&](int i, int j) {
    const Vec3 way = direction(i, j);
    return !skin.first_crossing(ball.centre + 0.9 * ball.radius * way, way, 1.3 * ball.radius).has_value();
  };
  std::set<std::pair<int, int>> seen;
  std::vector<std::pair<int, int>> open;
  for (int r = 0; r <= 8 && open.empty(); ++r)
    for (const auto& [i, j] : {std::pair{0, -r}, {0, r}, {r, 0}, {-r, 0}})
      if (open.empty() && free(i, j)) open.push_back({i, j});
  if (open.empty()) return {};
  seen.insert(open[0]);
  std::pair<int, int> in = open[0], out = open[0], up = open[0], down = open[0];
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (i < in.first) in = {i, j};
    if (i > out.first) out = {i, j};
    if (j > up.second) up = {i, j};
    if (j < down.second) down = {i, j};
    for (const auto& [a, b] : {std::pair{i + 1, j}, {i - 1, j}, {i, j + 1}, {i, j - 1}})
      if (std::abs(a) < half && std::abs(b) < half && !seen.contains({a, b}) && free(a, b)) {
        seen.insert({a, b});
        open.push_back({a, b});
      }
  }
  if (out.first - in.first < 8 || out.first >= half - 1 || in.first <= 1 - half) return {};
  // The lids' skin just beyond what is seen.
  const auto at = [&](int i, int j) {
    const Vec3 way = direction(i, j);
    const auto hit = skin.first_crossing(ball.centre + 0.9 * ball.radius * way, way, 1.3 * ball.radius);
    return ball.centre + (0.9 * ball.radius + hit.value_or(0.12 * ball.radius)) * way;
  };
  return Opening{at(in.first - 1, in.second), at(out.first + 1, out.second), at(up.first, up.second + 1),
                 at(down.first, down.second - 1)};
}

}  // namespace

Landmarks find_visible_eyes(const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& others,
                            const TriangleTree& skin, double middle, const Vec3& nose_tip, double unit) {
  std::array<std::optional<FittedBall>, 2> found;
  for (const FittedBall& ball : balls(positions, others, nose_tip, unit)) {
    auto& best = found[ball.centre.x > middle ? 0 : 1];
    if (!best || ball.error < best->error) best = ball;
  }
  if (!found[0] || !found[1] || std::abs(found[0]->radius / found[1]->radius - 1.0) > 0.2) return {};
  Landmarks out;
  for (const std::size_t side : {0u, 1u}) {
    const std::string end = side == 0 ? "Left" : "Right";
    const auto seen = opening(*found[side], skin, side == 0 ? 1.0 : -1.0);
    if (!seen) return {};
    out["eyeInner" + end] = seen->inner;
    out["eyeOuter" + end] = seen->outer;
    out["lidUpper" + end] = seen->upper;
    out["lidLower" + end] = seen->lower;
  }
  return out;
}

}  // namespace sinew
