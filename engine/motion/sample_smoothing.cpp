#include "engine/motion/sample_smoothing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sinew {
namespace {

constexpr int band = 3;  ///< the order of the differences
constexpr double parameter_price = 1.2;
/// Samples: the penalty is the sixth power of a wave's length, and beyond this one too much of the sums' digits.
constexpr double longest_wave = 250.0;
constexpr std::array<double, band + 1> difference{-1.0, 3.0, -3.0, 1.0};

/// A symmetric banded matrix's diagonal and what stands `band` places to the right of it, row by row.
using Row = std::array<double, band + 1>;

/// D^T D.
std::vector<Row> squared_differences(std::size_t samples) {
  std::vector<Row> rows(samples, Row{});
  for (std::size_t i = 0; i + band < samples; ++i)
    for (int a = 0; a <= band; ++a)
      for (int b = a; b <= band; ++b) rows[i + a][b - a] += difference[a] * difference[b];
  return rows;
}

/// I + penalty D^T D = U^T diag U, U with a unit diagonal; row[0] holds diag, the rest U.
std::vector<Row> factorised(const std::vector<Row>& squared, double penalty) {
  const std::size_t n = squared.size();
  std::vector<Row> rows(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (int b = 0; b <= band; ++b) rows[i][b] = penalty * squared[i][b] + (b == 0 ? 1.0 : 0.0);
    for (int back = 1; back <= band && static_cast<std::size_t>(back) <= i; ++back) {
      const Row& above = rows[i - back];
      const double scaled = above[back] * above[0];
      for (int b = 0; b + back <= band; ++b) rows[i][b] -= scaled * above[b + back];
    }
    for (int b = 1; b <= band; ++b) rows[i][b] /= rows[i][0];
  }
  return rows;
}

std::vector<double> solved(const std::vector<Row>& factor, std::span<const double> right) {
  const std::size_t n = factor.size();
  std::vector<double> x(right.begin(), right.end());
  for (std::size_t i = 0; i < n; ++i)
    for (int b = 1; b <= band && i + b < n; ++b) x[i + b] -= factor[i][b] * x[i];
  for (std::size_t i = n; i-- > 0;) {
    x[i] /= factor[i][0];
    for (int b = 1; b <= band && i + b < n; ++b) x[i] -= factor[i][b] * x[i + b];
  }
  return x;
}

/// The trace of the inverse from its band alone, last row first.
double inverse_trace(const std::vector<Row>& factor) {
  const std::size_t n = factor.size();
  std::vector<Row> inverse(n, Row{});
  const auto at = [&](std::size_t i, std::size_t j) { return inverse[std::min(i, j)][i < j ? j - i : i - j]; };
  double trace = 0.0;
  for (std::size_t i = n; i-- > 0;) {
    for (int b = band; b >= 0; --b) {
      if (i + b >= n) continue;
      double sum = b == 0 ? 1.0 / factor[i][0] : 0.0;
      for (int k = 1; k <= band && i + k < n; ++k) sum -= factor[i][k] * at(i + k, i + b);
      inverse[i][b] = sum;
    }
    trace += inverse[i][0];
  }
  return trace;
}

}  // namespace

double SmoothedSamples::standard_error() const {
  return values.empty() ? 0.0 : noise * std::sqrt(effective_parameters / static_cast<double>(values.size()));
}

SmoothedSamples smooth_samples(std::span<const double> samples, double resolution) {
  const std::size_t n = samples.size();
  SmoothedSamples best{{samples.begin(), samples.end()}, static_cast<double>(n), 0.0};
  if (n < 8) return best;
  const auto count = static_cast<double>(n);
  const std::vector<Row> squared = squared_differences(n);
  double best_score = INFINITY;
  for (double period = 2.0; period <= std::min(2.0 * count, longest_wave); period *= 1.3) {
    // Differences of order three damp a wave of this period to half.
    const double penalty = std::pow(2.0 * std::sin(std::numbers::pi / period), -2.0 * band);
    const std::vector<Row> factor = factorised(squared, penalty);
    const std::vector<double> smooth = solved(factor, samples);
    const double parameters = inverse_trace(factor);
    double squares = 0.0;
    for (std::size_t i = 0; i < n; ++i) squares += (samples[i] - smooth[i]) * (samples[i] - smooth[i]);
    const double left = 1.0 - parameter_price * parameters / count;
    if (left <= 0.0) continue;
    const double score = (squares / count + resolution * resolution) / (left * left);
    if (score >= best_score) continue;
    best_score = score;
    best = {smooth, parameters, std::sqrt(squares / (count - parameters))};
  }
  return best;
}

std::vector<std::size_t> find_jumps(std::span<const double> samples, double resolution) {
  constexpr std::size_t reach = 6, fewest = 3;
  constexpr double times = 10.0;
  std::vector<double> steps, others;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) steps.push_back(std::abs(samples[i + 1] - samples[i]));
  std::vector<std::size_t> jumps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    others.clear();
    for (std::size_t j = i > reach ? i - reach : 0; j < std::min(i + reach + 1, steps.size()); ++j)
      if (j != i) others.push_back(steps[j]);
    if (others.size() < fewest) continue;
    const auto middle = others.begin() + static_cast<std::ptrdiff_t>(others.size() / 2);
    std::nth_element(others.begin(), middle, others.end());
    if (steps[i] > times * (*middle + resolution)) jumps.push_back(i);
  }
  return jumps;
}

}  // namespace sinew
