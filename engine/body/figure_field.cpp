#include "engine/body/figure_field.h"

namespace sinew {
namespace {

/// Caps and fillets together reach less far than this.
constexpr double margin = 0.07;

/// What a part counts where it is out of reach.
constexpr double far_away = 0.3;

constexpr double longest_step = 0.012;

/// Below this the squared gradient says nothing about the distance.
constexpr double least_squared_gradient = 0.05;

/// min(a, b) rounded over |a - b| < k: a - b falls below the minimum by up to k / 4.
FieldSample smooth_union(const FieldSample& a, const FieldSample& b, double k) {
  const double apart = std::abs(a.distance - b.distance);
  if (apart >= k) return a.distance <= b.distance ? a : b;
  const double h = (k - apart) / k;
  const double share_of_farther = 0.5 * h;
  const FieldSample& nearer = a.distance <= b.distance ? a : b;
  const FieldSample& farther = a.distance <= b.distance ? b : a;
  return {nearer.distance - 0.25 * h * h * k,
          (1.0 - share_of_farther) * nearer.gradient + share_of_farther * farther.gradient};
}

Bounds surface_bounds(const BodyPart& part) {
  Bounds bounds;
  constexpr int directions = 16;
  if (part.ball) {
    const double largest = *std::max_element(part.radius.values.begin(), part.radius.values.end());
    bounds.add(part.ball_centre - largest);
    bounds.add(part.ball_centre + largest);
    return bounds;
  }
  for (int row = 0; row < part.radius.rows; ++row)
    for (int k = 0; k < directions; ++k)
      bounds.add(part.on_surface(part.first + (part.last - part.first) * row / (part.radius.rows - 1),
                                 2.0 * std::numbers::pi * k / directions));
  return bounds;
}

}  // namespace

BodyField::BodyField(const MeasuredBody& body) : body_(body) {
  for (const BodyPart& part : body.parts) {
    Bounds bounds = surface_bounds(part);
    bounds.low -= margin;
    bounds.high += margin;
    reach_.push_back(bounds);
  }
}

FieldSample BodyField::node_at(int node, const Vec3& p) const {
  const UnionNode& n = body_.tree[static_cast<std::size_t>(node)];
  if (n.part < 0) return smooth_union(node_at(n.one, p), node_at(n.other, p), n.fillet);
  const Bounds& reach = reach_[static_cast<std::size_t>(n.part)];
  if (glm::any(glm::lessThan(p, reach.low)) || glm::any(glm::greaterThan(p, reach.high))) return {far_away, Vec3(0.0)};
  return body_.parts[static_cast<std::size_t>(n.part)].at(p);
}

FieldSample BodyField::at(const Vec3& p) const {
  FieldSample sample = node_at(static_cast<int>(body_.tree.size()) - 1, {std::abs(p.x), p.y, p.z});
  if (p.x < 0.0) sample.gradient.x = -sample.gradient.x;
  return sample;
}

Vec3 BodyField::step_to_surface(Vec3& p) const {
  const FieldSample sample = at(p);
  const double squared = glm::dot(sample.gradient, sample.gradient);
  Vec3 step = -sample.distance / std::max(squared, least_squared_gradient) * sample.gradient;
  const double length = glm::length(step);
  if (length > longest_step) step *= longest_step / length;
  p += step;
  return unit_or(sample.gradient, Vec3(0.0));
}

}  // namespace sinew
