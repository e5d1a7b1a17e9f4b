#include "engine/motion/smooth_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Cholesky>

namespace sinew {
namespace {

/// Sums over all samples, the place of a sample being -1 to 1.
struct Sums {
  SegmentMatrix gram = SegmentMatrix::Zero(max_coefficients, max_coefficients);  ///< of P_i P_j
  SegmentVector moment = SegmentVector::Zero(max_coefficients);                  ///< of P_i y
};

double place(const EvenSamples& samples, std::size_t i) {
  return 2.0 * static_cast<double>(i) / static_cast<double>(samples.last()) - 1.0;
}

Sums sums_over(const EvenSamples& samples) {
  Sums sums;
  for (std::size_t i = 0; i <= samples.last(); ++i) {
    const LegendreValues p = legendre_values(place(samples, i));
    for (int a = 0; a < max_coefficients; ++a) {
      for (int b = 0; b <= a; ++b) sums.gram(a, b) += p[a] * p[b];
      sums.moment[a] += p[a] * samples.values[i];
    }
  }
  return sums;
}

/// LDLT reads the lower triangle alone.
SegmentVector solved(const Sums& sums, int degree) {
  return SegmentMatrix(sums.gram.topLeftCorner(degree + 1, degree + 1))
      .ldlt()
      .solve(SegmentVector(sums.moment.head(degree + 1)));
}

PiecewisePolynomial lone_curve(const EvenSamples& samples, const SegmentVector& coefficients) {
  return {{samples.begin, samples.begin + static_cast<double>(samples.last()) * samples.spacing},
          {{coefficients.begin(), coefficients.end()}}};
}

}  // namespace

SegmentChain chain_of(const Segmentation& segmentation) {
  SegmentChain chain;
  for (std::size_t i = 0; i < segmentation.segments(); ++i)
    chain.segments.push_back(
        {segmentation.cuts[i], segmentation.cuts[i + 1] - segmentation.cuts[i], segmentation.degrees[i]});
  chain.shape.clear(segmentation.segments());
  return chain;
}

PiecewisePolynomial fit_smooth(SegmentTables& tables, const EvenSamples& samples, const Segmentation& segmentation) {
  assert(segmentation.cuts.front() == 0 && segmentation.cuts.back() == samples.last());
  SegmentChain chain = chain_of(segmentation);
  ChainProjection projection(tables);
  projection.prepare(chain.segments, false, false);
  projection.project(samples.values, chain.shape);
  return chain.curve(tables, samples.begin, samples.spacing);
}

PiecewisePolynomial fit_lone(const EvenSamples& samples, int degree) {
  return lone_curve(samples, solved(sums_over(samples), degree));
}

std::optional<PiecewisePolynomial> fit_lone_within(const EvenSamples& samples, double tolerance, int highest) {
  const Sums sums = sums_over(samples);
  const int most = static_cast<int>(std::min<std::size_t>(samples.last(), highest));
  for (int degree = 0; degree <= most; ++degree) {
    const SegmentVector c = solved(sums, degree);
    std::size_t i = 0;
    while (i <= samples.last() &&
           std::abs(legendre_sum({c.data(), static_cast<std::size_t>(c.size())}, place(samples, i)) -
                    samples.values[i]) <= tolerance)
      ++i;
    if (i > samples.last()) return lone_curve(samples, c);
  }
  return {};
}

std::vector<double> residuals(const PiecewisePolynomial& curve, std::span<const double> times,
                              std::span<const double> values) {
  std::vector<double> distances(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) distances[i] = values[i] - curve.value(times[i]);
  return distances;
}

}  // namespace sinew
