#include "engine/face/radial_warp.h"

#include <Eigen/LU>

namespace sinew {
RadialWarp::RadialWarp(std::span<const Vec3> from, std::span<const Vec3> to, std::span<const double> looseness,
                       double width)
    : centres_(from.begin(), from.end()), weights_(from.size(), Vec3(0.0)), width_(width) {
  const auto n = static_cast<Eigen::Index>(from.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n + 1, n + 1), b = Eigen::MatrixXd::Zero(n + 1, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (Eigen::Index j = 0; j < n; ++j) a(i, j) = spread(from[at] - from[static_cast<std::size_t>(j)]);
    // The kernel is negative definite: smoothing counts against it.
    a(i, i) -= looseness[at];
    a(i, n) = a(n, i) = 1.0;
    for (int c = 0; c < 3; ++c) b(i, c) = to[at][c] - from[at][c];
  }
  const Eigen::MatrixXd x = a.partialPivLu().solve(b);
  for (int c = 0; c < 3; ++c) {
    for (Eigen::Index i = 0; i < n; ++i) weights_[static_cast<std::size_t>(i)][c] = x(i, c);
    shift_[c] = x(n, c);
  }
}

Vec3 RadialWarp::point(const Vec3& p) const {
  Vec3 out = p + shift_;
  for (std::size_t i = 0; i < centres_.size(); ++i) out += spread(p - centres_[i]) * weights_[i];
  return out;
}

Mat3 RadialWarp::slope(const Vec3& p) const {
  Mat3 out(1.0);
  for (std::size_t i = 0; i < centres_.size(); ++i) {
    const Vec3 d = p - centres_[i];
    out += glm::outerProduct(weights_[i], d / spread(d));
  }
  return out;
}

}  // namespace sinew
