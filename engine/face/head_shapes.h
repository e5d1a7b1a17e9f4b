#pragma once
/// A head's channels and expressions as shapes for players that blend linearly.

#include <vector>

#include "engine/face/head_model.h"

namespace sinew {

/// One shape for each channel at each of its limits that it can reach alone (its name and "+" or "-", such as
/// "browLeft.up+"), then one for each expression, VRM preset and ARKit shape; `strict` leaves out of expressions what
/// the thesis does not have. Where lids shut, the eyeballs draw back a little with them: a lid that moves straight
/// instead of turning would dip below the ball half way.
std::vector<HeadShape> head_shapes(const Head& head, bool strict);

/// The head in one state, normals of its surface.
HeadShape posed_head(const Head& head, const FaceChannels& channels);

}  // namespace sinew
