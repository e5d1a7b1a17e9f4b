#include <algorithm>
#include <numeric>

#include "engine/face/head_parts.h"

namespace sinew {
namespace {

constexpr std::uint32_t sections = 15, round = 8;

/// The middle line and half height of the brow, t 0 (inner end) to 1.
class BrowLine {
 public:
  explicit BrowLine(const HeadPlan& plan) {
    const HeadMeasures& m = plan.m;
    const double x = m.eye_spacing, s = plan.eye_scale, b = plan.brow, rise = m.brow_inner_rise, arch = m.brow_arch;
    points_ = {Vec2{x - 0.31 * s, b + rise},
               {x - 0.14 * s, b + 0.6 * rise + 0.058 * arch},
               {x + 0.08 * s, b + 0.01 + 0.095 * arch},
               {x + 0.26 * s, b + 0.01 + 0.06 * arch},
               {x + 0.39 * s, b - 0.005}};
    thickness_ = m.brow_thickness * std::sqrt(s);
  }
  Vec2 at(double t) const {
    const double place = std::clamp(t, 0.0, 1.0) * 4.0;
    const int i = std::min(3, static_cast<int>(place));
    const double u = place - i;
    const auto p = [&](int k) {
      if (k < 0) return 2.0 * points_[0] - points_[1];
      if (k > 4) return 2.0 * points_[4] - points_[3];
      return points_[static_cast<std::size_t>(k)];
    };
    const Vec2 a = p(i - 1), b = p(i), c = p(i + 1), d = p(i + 2);
    return 0.5 * (2.0 * b + (c - a) * u + (2.0 * a - 5.0 * b + 4.0 * c - d) * u * u +
                  (3.0 * b - a - 3.0 * c + d) * u * u * u);
  }
  Vec2 normal(double t) const {
    const Vec2 along = at(std::min(1.0, t + 0.01)) - at(std::max(0.0, t - 0.01));
    return glm::normalize(Vec2(-along.y, along.x));
  }
  /// Blunt inside, running out to a point outside.
  double half_height(double t) const {
    return thickness_ * std::pow(std::clamp((t + 0.06) / 0.14, 0.0, 1.0), 0.6) *
           (1.0 - 0.80 * std::pow(std::max(0.0, (t - 0.25) / 0.75), 1.2));
  }

 private:
  std::array<Vec2, 5> points_;
  double thickness_;
};

/// The nearest vertices of the face as seen from the front. Their weights fall to 0 at the distance of the next one
/// (Franke and Nielson, Smooth interpolation of large sets of scattered data, 1980): where the brow slides on to other
/// vertices, as it does when a head grows older, it does not jump.
class FrontSkin {
 public:
  explicit FrontSkin(std::span<const Vec3> skin) : skin_(skin) {
    for (std::uint32_t v = 0; v < skin.size(); ++v)
      if (skin[v].z > 0.4) front_.push_back(v);
  }
  void find(const Vec2& p, std::array<std::uint32_t, 6>& vertices, std::array<double, 6>& weights) {
    const auto distance2 = [&](std::uint32_t v) {
      const Vec2 d = Vec2(skin_[v]) - p;
      return glm::dot(d, d);
    };
    std::partial_sort(front_.begin(), front_.begin() + 7, front_.end(), [&](std::uint32_t a, std::uint32_t b) {
      const double da = distance2(a), db = distance2(b);
      return da != db ? da < db : a < b;
    });
    constexpr double least = 1e-3;  // of a vertex on the very place
    const double reach = std::sqrt(distance2(front_[6])) + 1e-12;
    double sum = 0.0;
    for (std::size_t i = 0; i < 6; ++i) {
      vertices[i] = front_[i];
      const double distance = std::sqrt(distance2(front_[i]));
      sum += weights[i] = glm::pow(std::max(reach - distance, 1e-12) / (reach * (distance + least)), 2.0);
    }
    for (double& w : weights) w /= sum;
  }

 private:
  std::span<const Vec3> skin_;
  std::vector<std::uint32_t> front_;
};

}  // namespace

Brow build_brow(const HeadPlan& plan, std::span<const Vec3> skin) {
  constexpr double thickest = 0.030, lift = 0.008;
  const BrowLine line(plan);
  FrontSkin front(skin);
  Brow out;
  const auto add = [&](const Vec2& p, double above) {
    std::array<std::uint32_t, 6> vertices;
    std::array<double, 6> weights;
    front.find(p, vertices, weights);
    double z = 0.0;
    for (std::size_t i = 0; i < 6; ++i) z += weights[i] * skin[vertices[i]].z;
    out.surface.positions.emplace_back(p, z + above);
    out.anchors.push_back(vertices);
    out.anchor_weights.push_back(weights);
  };
  for (std::uint32_t s = 0; s < sections; ++s) {
    const double t = double(s) / (sections - 1), half = line.half_height(t);
    for (std::uint32_t k = 0; k < round; ++k) {
      const double turn = 2 * std::numbers::pi * k / round;
      const Vec2 p = line.at(t) + half * std::cos(turn) * line.normal(t);
      add(p, thickest * std::sin(turn) * std::min(1.0, half / 0.03) + lift);
      if (k % 4 == 0) out.outline.push_back(p);
    }
  }
  for (const double t : {0.0, 1.0}) add(line.at(t), lift);
  const auto at = [](std::uint32_t s, std::uint32_t k) { return s * round + k % round; };
  const std::uint32_t inner = sections * round, outer = inner + 1;
  for (std::uint32_t k = 0; k < round; ++k) {
    for (std::uint32_t s = 0; s + 1 < sections; ++s)
      out.surface.quad(at(s, k), at(s, k + 1), at(s + 1, k + 1), at(s + 1, k), HeadMaterial::brow);
    out.surface.triangles.push_back({{inner, at(0, k + 1), at(0, k)}, HeadMaterial::brow});
    out.surface.triangles.push_back({{outer, at(sections - 1, k), at(sections - 1, k + 1)}, HeadMaterial::brow});
  }
  return out;
}

}  // namespace sinew
