#pragma once
/// Fitted weights freed of what noise in the examples put into them. engine/definitions.md 16.

#include <vector>

#include "engine/fit/surface_graph.h"
#include "engine/fit/vertex_fit.h"

namespace sinew {

/// Variance of the examples' noise a coordinate: the median over vertices of error / (3 poses - free weights). Examples
/// that no weights fit count as noise.
double noise_variance(const std::vector<Support>& fitted, std::size_t poses);

/// A vertex's weights moved towards its neighbours' as far as noise explains that they differ. Each neighbour counts
/// by how well its weights fit this vertex, so that nothing crosses a real edge; the weights go to
/// `(1 - s) own + s mean` with `s = noise expected / what the mean fits worse`, James and Stein's factor, at most 1:
/// without noise they stay. `current`: [vertices] of the round before. At most `influences` bones are kept. `fit` is at
/// this vertex.
Support smoothed(VertexFit& fit, const Support& own, std::span<const std::uint32_t> neighbours,
                 const std::vector<Support>& current, double variance, std::size_t influences);

}  // namespace sinew
