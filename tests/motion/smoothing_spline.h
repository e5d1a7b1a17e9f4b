#pragma once
/// The textbook's rival of piecewise polynomials: Reinsch's cubic smoothing spline (1967) through evenly spaced
/// samples, its parameter by generalised cross-validation, dense and slow on purpose.

#include <vector>

#include <Eigen/Dense>

namespace sinew::test {

/// The spline's values at the samples.
inline std::vector<double> smoothing_spline(const std::vector<double>& samples) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd q = Eigen::MatrixXd::Zero(n, n - 2), r = Eigen::MatrixXd::Zero(n - 2, n - 2);
  for (Eigen::Index i = 0; i < n - 2; ++i) {
    q(i, i) = q(i + 2, i) = 1.0;
    q(i + 1, i) = -2.0;
    r(i, i) = 2.0 / 3.0;
    if (i > 0) r(i, i - 1) = r(i - 1, i) = 1.0 / 6.0;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> roughness(q * r.inverse() * q.transpose());
  const Eigen::Map<const Eigen::VectorXd> y(samples.data(), n);
  const Eigen::VectorXd modes = roughness.eigenvectors().transpose() * y;
  double best_score = INFINITY;
  Eigen::VectorXd best = y;
  for (double exponent = -4.0; exponent < 6.0; exponent += 0.1) {
    const Eigen::ArrayXd kept = 1.0 / (1.0 + std::pow(10.0, exponent) * roughness.eigenvalues().array());
    const Eigen::VectorXd smooth = roughness.eigenvectors() * (kept * modes.array()).matrix();
    const double left = 1.0 - kept.sum() / static_cast<double>(n);
    const double score = (y - smooth).squaredNorm() / (left * left);
    if (score < best_score) {
      best_score = score;
      best = smooth;
    }
  }
  return {best.begin(), best.end()};
}

}  // namespace sinew::test
