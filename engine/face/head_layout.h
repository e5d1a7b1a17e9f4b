#pragma once
/// Texture coordinates of a head's skin.

#include "engine/face/head_skin.h"

namespace sinew {

/// The skin laid out flat in one piece without seams, the neck's base as a circle round the crown: each point of the
/// cage is the mean of its neighbours (Tutte, How to draw a graph, 1963), so that nothing overlaps and eyes and mouth,
/// where points are dense, have the most room.
std::vector<Vec2> skin_layout(const HeadTopology& topology);

}  // namespace sinew
