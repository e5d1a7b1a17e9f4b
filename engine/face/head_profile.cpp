#include "engine/face/head_profile.h"

#include <algorithm>

namespace sinew {
namespace {

constexpr double open_lips = 0.08;  ///< of a drawing unit: a groove that is deeper is an open mouth

/// Depths of the skin as seen from the front along a vertical line, from the crown down.
struct Line {
  double top = 0.0, step = 0.0;
  std::vector<double> depth;  ///< -infinity where there is no skin

  double height(std::size_t i) const { return top - static_cast<double>(i) * step; }
  std::size_t at(double y) const {
    return static_cast<std::size_t>(std::clamp((top - y) / step, 0.0, static_cast<double>(depth.size() - 1)));
  }
  /// The foremost or hindmost place between two heights, ends left out unless nothing lies between.
  std::size_t extreme(std::size_t from, std::size_t to, bool foremost) const {
    std::size_t best = from;
    for (std::size_t i = from; i <= to && i < depth.size(); ++i)
      if (foremost ? depth[i] > depth[best] : depth[i] < depth[best]) best = i;
    return best;
  }
};

Line line_at(const TriangleTree& tree, double x, double top, double low, double front, double reach, std::size_t n) {
  Line out{top, (top - low) / static_cast<double>(n), {}};
  for (std::size_t i = 0; i < n; ++i) {
    const auto hit = tree.first_crossing({x, out.height(i), front}, {0, 0, -1}, reach);
    out.depth.push_back(hit ? front - *hit : -INFINITY);
  }
  return out;
}

}  // namespace

std::optional<HeadProfile> find_profile(const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& skin,
                                        const TriangleTree& tree) {
  constexpr std::size_t steps = 420, least_triangles = 60;
  if (skin.size() < 3 * least_triangles) return {};
  Bounds box;
  for (const std::uint32_t v : skin) box.add(positions[v]);
  HeadProfile out;
  out.middle = box.centre().x;
  const double front = box.high.z + 1.0, reach = box.high.z - box.low.z + 2.0, height = box.high.y - box.low.y;
  const Line line = line_at(tree, out.middle + 1e-5 * height, box.high.y, box.low.y, front, reach, steps);
  const std::size_t nose = line.extreme(steps / 5, steps * 17 / 20, true);
  if (!std::isfinite(line.depth[nose])) return {};
  const auto place = [&](std::size_t i) { return Vec3(out.middle, line.height(i), line.depth[i]); };
  out.crown = {out.middle, box.high.y, 0.0};
  out.nose_tip = place(nose);
  // The head is about as deep as it is high; the face below the nose is two fifths of what is above it.
  const double depth = box.high.z - box.low.z, above = box.high.y - line.height(nose);
  const double unit = above / 2.4;
  // The chin's underside, from below: where the outline has come out from the neck nearly as far as the lips.
  constexpr double behind_lips = 0.34;
  const std::size_t lowest = line.at(line.height(nose) - 1.85 * unit);
  const double lips = line.depth[line.extreme(line.at(line.height(nose) - 0.45 * unit),
                                              line.at(line.height(nose) - 0.85 * unit), true)];
  std::size_t chin = lowest;
  while (chin > nose && !(line.depth[chin] > lips - behind_lips * unit)) --chin;
  out.chin = place(chin);
  if (!std::isfinite(out.chin.z) || depth <= 0.0) return {};
  // Nose, then the dents and rises of the lips, as far as the skin has any.
  const double below = line.height(nose) - line.height(chin);
  const std::size_t base_to = line.at(line.height(nose) - 0.40 * below);
  std::size_t base = nose;
  for (std::size_t i = nose + 1; i <= base_to; ++i) {
    base = i;
    if (i + 2 < line.depth.size() && line.depth[i + 1] >= line.depth[i] && line.depth[i + 2] >= line.depth[i]) break;
  }
  out.nose_base = place(base);
  out.has_nose = line.depth[nose] - line.depth[base] > 0.08 * unit;
  const std::size_t from = line.at(line.height(base) - 0.06 * below), to = line.at(line.height(nose) - 0.74 * below);
  double deepest = 0.0;
  for (std::size_t i = from + 2; i + 2 < to; ++i) {
    const std::size_t window = std::max<std::size_t>(3, static_cast<std::size_t>(0.11 * below / line.step));
    const double upper = line.depth[line.extreme(i > from + window ? i - window : from, i, true)],
                 lower = line.depth[line.extreme(i, std::min(to, i + window), true)];
    const double dent = std::min(upper, lower) - line.depth[i];
    if (dent > deepest) {
      deepest = dent;
      out.lip_contact = place(i);
      // Between lips that part a little the line goes into the mouth.
      out.lip_contact.z = std::max(out.lip_contact.z, std::min(upper, lower) - open_lips * unit);
    }
  }
  out.has_lips = out.has_nose && deepest > 0.01 * unit;
  return out;
}

std::optional<Vec3> find_lip_corner(const TriangleTree& tree, const HeadProfile& profile, int side, double reach,
                                    double unit) {
  constexpr std::size_t steps = 60;
  const double band = 0.16 * unit, front = profile.nose_tip.z + unit;
  double y = profile.lip_contact.y, first_dent = 0.0;
  std::optional<Vec3> best;
  for (double x = 0.04 * unit; x < 1.35 * reach; x += 0.02 * unit) {
    const double at = profile.middle + side * x;
    const Line line = line_at(tree, at, y + band, y - band, front, 4 * unit, steps);
    double deepest = 0.0, lips = 0.0;
    std::size_t where = steps / 2;
    // Near the groove of the step before.
    for (std::size_t i = steps / 2 - 9; i <= steps / 2 + 9; ++i) {
      const double upper = line.depth[line.extreme(i - 16, i, true)], lower = line.depth[line.extreme(i, i + 16, true)];
      const double dent = std::min(upper, lower) - line.depth[i];
      if (dent > deepest) deepest = dent, where = i, lips = std::min(upper, lower);
    }
    // Between lips that part a little the line goes into the mouth.
    deepest = std::min(deepest, open_lips * unit);
    if (x < 0.15 * unit) first_dent = std::max(first_dent, deepest);
    if (deepest < 0.12 * first_dent) break;
    y = line.height(where);
    best = Vec3(at, y, std::max(line.depth[where], lips - open_lips * unit));
  }
  if (!best || std::abs(best->x - profile.middle) < 0.6 * reach) return {};
  return best;
}

}  // namespace sinew
