#pragma once
/// The smooth piecewise polynomial nearest to samples, its cuts given: least squares with value and slope continuous.

#include <optional>

#include "engine/motion/segment_chain.h"

namespace sinew {

/// A curve's samples, evenly spaced in time.
struct EvenSamples {
  double begin = 0.0;              ///< seconds, of the first
  double spacing = 1.0;            ///< seconds, > 0
  std::span<const double> values;  ///< [samples >= 2]

  std::size_t last() const { return values.size() - 1; }
};

/// Where a curve is cut and how it bends between. Cuts stand at samples.
struct Segmentation {
  std::vector<std::size_t> cuts;  ///< [segments + 1] sample indices, rising, from 0 to the last sample
  std::vector<int> degrees;       ///< [segments] 3 to 8, no higher than the samples can tell apart

  std::size_t segments() const { return degrees.size(); }
};

/// The segments, all numbers 0.
SegmentChain chain_of(const Segmentation& segmentation);

/// Minimises sum (f(t_i) - y_i)^2 over all such curves. A trace of curvature (integral f''^2) in the sum decides
/// between curves where samples do not. `tables` reach to the longest segment.
PiecewisePolynomial fit_smooth(SegmentTables& tables, const EvenSamples& samples, const Segmentation& segmentation);

/// The best single polynomial over all samples, degree 0 to 8, below the number of samples.
PiecewisePolynomial fit_lone(const EvenSamples& samples, int degree);

/// The best single polynomial of the least degree, up to `highest`, that leaves no sample further than `tolerance`;
/// nothing where there is none.
std::optional<PiecewisePolynomial> fit_lone_within(const EvenSamples& samples, double tolerance, int highest);

/// Distances of the samples from the curve, [samples].
std::vector<double> residuals(const PiecewisePolynomial& curve, std::span<const double> times,
                              std::span<const double> values);

}  // namespace sinew
