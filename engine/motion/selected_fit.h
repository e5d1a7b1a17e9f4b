#pragma once
/// Segments as noisy samples themselves recommend them.

#include "engine/motion/smooth_fit.h"

namespace sinew {

/// A curve that resists noise: the samples are smoothed (smooth_samples,
/// filter_waves; apart on either side of a jump), and the curve follows what is
/// left within a share of its own standard error, or within `resolution` where that is more, with as few segments as
/// this takes, degrees up to `highest_degree`, 3 to 8.
PiecewisePolynomial fit_selected(SegmentTables& tables, const EvenSamples& samples, int highest_degree,
                                 double resolution);

/// Cuts that make so many segments, at the most prominent extrema of the smoothed samples, then halving the longest
/// segment; fewer where there are not enough samples. [segments + 1] sample indices, the ends among them.
std::vector<std::size_t> cuts_for(std::span<const double> values, std::size_t segments, double resolution);

}  // namespace sinew
