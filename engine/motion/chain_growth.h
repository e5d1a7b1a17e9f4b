#pragma once
/// Segments laid one after another, as long as a tolerance lets them be.

#include "engine/motion/tube_fit.h"

namespace sinew {

/// A row over all the samples within the tolerance, degrees `degree` (3 to 8) or what the samples can tell apart.
SegmentChain grow_chain(TubeFit& tube, int degree);

/// The most steps of a grown segment: a bound for the tables, which longer segments would hardly be fewer for.
constexpr std::size_t longest_grown = 1000;

}  // namespace sinew
