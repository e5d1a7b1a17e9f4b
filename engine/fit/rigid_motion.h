#pragma once
/// The rigid motion that carries weighted points to targets best.

#include "engine/core/math.h"

namespace sinew {

/// Gathers points one by one and solves `min over R, t of sum |w (R p + t) - q|^2`, R a rotation. Kabsch 1976; the
/// weights as in Le and Deng 2012, equation 8.
class RigidMotion {
 public:
  /// `q` is where the point ought to be times its weight.
  void add(const Vec3& p, const Vec3& q, double weight);
  double weight() const { return weight_; }  ///< sum of the squared weights
  /// `fallback` where nothing was added.
  Mat34 solve(const Mat34& fallback) const;

 private:
  double weight_ = 0.0;
  Vec3 p_{0.0}, q_{0.0};  ///< sums of w^2 p and of w q
  Mat3 products_{0.0};    ///< sum of w q p^T
};

}  // namespace sinew
