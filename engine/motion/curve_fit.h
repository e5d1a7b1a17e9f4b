#pragma once
/// A joint angle's samples as a piecewise polynomial: engine/definitions.md 14.

#include <optional>
#include <span>

#include "engine/motion/piecewise_polynomial.h"

namespace sinew {

class SegmentTables;

struct CurveFitOptions {
  std::optional<int> degree;        ///< 3 to 8: of every segment; with a tolerance the highest (else 8)
  std::optional<int> segments;      ///< nothing: as many as the tolerance or the noise asks
  std::optional<double> tolerance;  ///< > 0, in the values' unit; nothing: as the noise asks
  double resolution = 0.1;          ///< what the samples are not known better than, where there is no tolerance
};

struct CurveFit {
  PiecewisePolynomial curve;
  double rms_error = 0.0;      ///< over the samples
  double largest_error = 0.0;  ///< over the samples
};

/// How far a curve is from samples.
CurveFit measured_curve(PiecewisePolynomial curve, std::span<const double> times, std::span<const double> values);

constexpr int default_fit_degree = 5;  ///< the paper's, where there is no tolerance

/// Fails as usage with the option's name where one is out of its range.
Result<void> check_fit_options(const CurveFitOptions& options);

/// `times`: [samples >= 1] seconds, evenly spaced; `values`: [samples], finite. Options as check_fit_options() wants
/// them. A curve that does not move is one segment of degree 0; too few samples for a degree lower it. `tables`, which
/// curves of as many samples may share, reach to all of the samples.
CurveFit fit_curve(SegmentTables& tables, std::span<const double> times, std::span<const double> values,
                   const CurveFitOptions& options);
/// The same with tables of its own.
CurveFit fit_curve(std::span<const double> times, std::span<const double> values, const CurveFitOptions& options);

}  // namespace sinew
