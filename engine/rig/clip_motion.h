#pragma once
/// A model's animation as a motion of its skeleton.

#include "engine/core/result.h"
#include "engine/model/model.h"
#include "engine/model/motion.h"

namespace sinew {

/// The clip on the nodes that it moves, that a skin names or that the file's humanoid map has, with all between them.
/// Frames stand at the clip's own rate where its keys are evenly spaced, else at 60 a second, which is noted. Scales,
/// and nodes above the topmost joint, are worked into places and rotations; a metre is a unit. Fails as bad_input where
/// nothing is left to move, or where the frames would be more than 2^24 joints times frames.
Result<Motion> motion_from_clip(const Model& model, const Clip& clip);

}  // namespace sinew
