#pragma once
/// A smooth map of space through given places: radial basis functions.

#include <span>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

/// p + c + sum w_i sqrt(|p - q_i|^2 + width^2), sum w_i = 0: multiquadrics (Hardy 1971), conditionally definite of
/// order one (Micchelli 1986), so that it exists for any distinct places and tends to a mere shift far from them.
class RadialWarp {
 public:
  /// The map that takes `from` to `to`. `looseness`: [from] 0 to go through a place, more to pass beside it the
  /// farther. Drawing units. Places that are nearer to each other than a third of the width must be loose.
  RadialWarp(std::span<const Vec3> from, std::span<const Vec3> to, std::span<const double> looseness,
             double width = 0.12);

  Vec3 point(const Vec3& p) const;
  /// The map's derivative: what becomes of a small step.
  Mat3 slope(const Vec3& p) const;

 private:
  double spread(const Vec3& d) const { return std::sqrt(glm::dot(d, d) + width_ * width_); }

  std::vector<Vec3> centres_, weights_;
  Vec3 shift_{0.0};
  double width_;
};

}  // namespace sinew
