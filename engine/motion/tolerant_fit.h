#pragma once
/// Segments and degrees as few as a tolerance allows.

#include "engine/motion/smooth_fit.h"

namespace sinew {

/// A smooth curve within `tolerance` of every sample, with few stored numbers, degrees up to `highest_degree` (3 to 8).
/// One polynomial where one does. Else segments are laid one after another, each as long as the tolerance lets it be
/// and then cut at its last great extremum, if that is not far back; cuts and degrees that can be done without are
/// taken away. A tolerance below what rounding allows ends with a cut at every sample.
PiecewisePolynomial fit_within(SegmentTables& tables, const EvenSamples& samples, double tolerance, int highest_degree);

/// The same with cuts that are given: degrees rise from 3 as the tolerance asks, which they may not reach.
PiecewisePolynomial fit_degrees_within(SegmentTables& tables, const EvenSamples& samples,
                                       const std::vector<std::size_t>& cuts, double tolerance, int highest_degree);

}  // namespace sinew
