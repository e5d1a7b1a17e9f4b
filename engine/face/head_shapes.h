#pragma once
/// A head's channels and expressions as shapes for players that blend linearly.

#include <vector>

#include "engine/face/head_model.h"

namespace sinew {

/// Those of shape_recipes(), with the surface's own normals.
std::vector<HeadShape> head_shapes(const Head& head, bool strict);

/// The head in one state, normals of its surface.
HeadShape posed_head(const Head& head, const FaceChannels& channels);

}  // namespace sinew
