#pragma once
/// Segments and degrees as few as a tolerance allows.

#include "engine/motion/smooth_fit.h"

namespace sinew {

/// A smooth curve within `tolerance` of every sample, with few stored numbers: cut at extrema more prominent than twice
/// the tolerance, segments that miss it given more degrees up to `highest_degree` (3 to 8) and then cut again, down to
/// single samples, then cuts and degrees that it can do without taken away. A tolerance below what rounding allows ends
/// with a cut at every sample.
PiecewisePolynomial fit_within(SmoothFitter& fitter, double tolerance, int highest_degree);

/// The same with cuts that are given: degrees rise from 3 as the tolerance asks, which they may not reach.
PiecewisePolynomial fit_degrees_within(SmoothFitter& fitter, const std::vector<std::size_t>& cuts, double tolerance,
                                       int highest_degree);

}  // namespace sinew
