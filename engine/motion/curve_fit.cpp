#include "engine/motion/curve_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/motion/selected_fit.h"
#include "engine/motion/smooth_fit.h"
#include "engine/motion/tolerant_fit.h"

namespace sinew {
namespace {

constexpr double still = 1e-9;  ///< a range of values that is rounding alone

Segmentation of_one_degree(SegmentTables& tables, const std::vector<std::size_t>& cuts, int degree) {
  Segmentation segmentation{cuts, {}};
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    segmentation.degrees.push_back(std::min(degree, tables.of(cuts[i + 1] - cuts[i]).highest_degree));
  return segmentation;
}

PiecewisePolynomial fitted(SegmentTables& tables, const EvenSamples& samples, const CurveFitOptions& options) {
  const int most = static_cast<int>(std::min<std::size_t>(samples.last(), max_degree));
  if (most < lowest_smooth_degree) return fit_lone(samples, most);
  const int degree = std::min(options.degree.value_or(options.tolerance ? max_degree : default_fit_degree), most);
  if (!options.segments) {
    if (options.tolerance) return fit_within(tables, samples, *options.tolerance, degree);
    return fit_selected(tables, samples, degree, options.resolution);
  }
  if (*options.segments == 1 && !options.tolerance) return fit_lone(samples, degree);
  const auto cuts = cuts_for(samples.values, static_cast<std::size_t>(*options.segments), options.resolution);
  if (options.tolerance) return fit_degrees_within(tables, samples, cuts, *options.tolerance, degree);
  return fit_smooth(tables, samples, of_one_degree(tables, cuts, degree));
}

}  // namespace

Result<void> check_fit_options(const CurveFitOptions& options) {
  if (options.degree && (*options.degree < lowest_smooth_degree || *options.degree > max_degree))
    return failure(ErrorKind::usage,
                   "--degree {}: expected {} to {}; below {} value and slope cannot both join at the cuts",
                   *options.degree, lowest_smooth_degree, max_degree, lowest_smooth_degree);
  if (options.segments && (*options.segments < 1 || *options.segments > 100000))
    return failure(ErrorKind::usage, "--segments {}: expected auto, or a number from 1 to 100000", *options.segments);
  if (options.tolerance && !(*options.tolerance > 0.0 && std::isfinite(*options.tolerance)))
    return failure(ErrorKind::usage, "--tolerance {}: expected a number above 0", *options.tolerance);
  return {};
}

CurveFit measured_curve(PiecewisePolynomial curve, std::span<const double> times, std::span<const double> values) {
  CurveFit fit{std::move(curve), 0.0, 0.0};
  double squares = 0.0;
  for (const double residual : residuals(fit.curve, times, values)) {
    squares += residual * residual;
    fit.largest_error = std::max(fit.largest_error, std::abs(residual));
  }
  fit.rms_error = std::sqrt(squares / static_cast<double>(times.size()));
  return fit;
}

CurveFit fit_curve(SegmentTables& tables, std::span<const double> times, std::span<const double> values,
                   const CurveFitOptions& options) {
  assert(!times.empty() && times.size() == values.size());
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double middle = 0.5 * (*low + *high);
  PiecewisePolynomial curve;
  if (times.size() == 1 || *high - *low <= std::max(still, 2.0 * options.tolerance.value_or(0.0))) {
    // One sample has no length of time; a second stands for it.
    curve = constant_curve(times.front(), times.size() == 1 ? times.front() + 1.0 : times.back(), middle);
  } else {
    // Sums of squares lose fewest digits about the middle.
    std::vector<double> centred(values.begin(), values.end());
    for (double& value : centred) value -= middle;
    const double spacing = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    curve = fitted(tables, {times.front(), spacing, centred}, options);
    for (auto& segment : curve.coefficients) segment[0] += middle;
  }
  return measured_curve(std::move(curve), times, values);
}

CurveFit fit_curve(std::span<const double> times, std::span<const double> values, const CurveFitOptions& options) {
  SegmentTables tables(times.size());
  return fit_curve(tables, times, values, options);
}

}  // namespace sinew
