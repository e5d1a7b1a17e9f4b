#include "engine/fit/weight_smoothing.h"

#include <algorithm>

namespace sinew {
namespace {

/// A neighbour whose weights miss this vertex by more than so many variances counts less than half. Two noisy sets of
/// up to three free weights differ by 6 on the mean; twice that is left for weights that change along the surface.
constexpr double neighbour_reach = 12.0;

/// Less than this share of the neighbours' mean is left out: it would only spread supports.
constexpr double least_share = 1e-6;

/// Bones of a mean, as many as neighbours bring.
struct Mean {
  std::vector<std::pair<std::uint32_t, double>> weights;

  void add(const Support& support, double factor) {
    for (std::size_t i = 0; i < support.size; ++i) {
      const auto found = std::find_if(weights.begin(), weights.end(),
                                      [&](const auto& entry) { return entry.first == support.bone[i]; });
      if (found == weights.end())
        weights.emplace_back(support.bone[i], factor * support.weight[i]);
      else
        found->second += factor * support.weight[i];
    }
  }

  /// The `influences` largest, their sum 1.
  Support largest(std::size_t influences) {
    std::sort(weights.begin(), weights.end(), [](const auto& a, const auto& b) {
      return a.second != b.second ? a.second > b.second : a.first < b.first;
    });
    weights.resize(std::min(weights.size(), influences));
    double sum = 0.0;
    for (const auto& entry : weights) sum += entry.second;
    Support support;
    for (const auto& [bone, weight] : weights) support.add(bone, weight / sum);
    return support;
  }
};

}  // namespace

double noise_variance(const std::vector<Support>& fitted, std::size_t poses) {
  std::vector<double> variances;
  for (const Support& support : fitted)
    if (3 * poses + 1 > support.size)
      variances.push_back(support.error / static_cast<double>(3 * poses + 1 - support.size));
  if (variances.empty()) return 0.0;
  const auto middle = variances.begin() + static_cast<std::ptrdiff_t>(variances.size() / 2);
  std::nth_element(variances.begin(), middle, variances.end());
  return *middle;
}

Support smoothed(VertexFit& fit, const Support& own, std::span<const std::uint32_t> neighbours,
                 const std::vector<Support>& current, double variance, std::size_t influences) {
  if (neighbours.empty() || variance <= 0.0) return own;
  const double own_error = fit.residual(own).squaredNorm();
  Eigen::VectorXd mean_residual;
  Mean mean;
  double total = 0.0;
  for (const std::uint32_t n : neighbours) {
    const Eigen::VectorXd r = fit.residual(current[n]);
    const double excess = std::max(r.squaredNorm() - own_error, 0.0) / (neighbour_reach * variance);
    const double counts = 1.0 / (1.0 + excess * excess);
    if (mean_residual.size() == 0)
      mean_residual = counts * r;
    else
      mean_residual += counts * r;
    mean.add(current[n], counts);
    total += counts;
  }
  if (!(total > 0.0)) return own;
  for (auto& entry : mean.weights) entry.second /= total;
  const double excess = (mean_residual / total).squaredNorm() - own_error;
  const double expected = variance * static_cast<double>(std::max<std::size_t>(own.size - 1, 1));
  const double share = excess > expected ? expected / excess : 1.0;
  if (share < least_share) return own;
  for (auto& entry : mean.weights) entry.second *= share;
  mean.add(own, 1.0 - share);
  Support out = mean.largest(influences);
  out.error = fit.residual(out).squaredNorm();
  return out;
}

}  // namespace sinew
