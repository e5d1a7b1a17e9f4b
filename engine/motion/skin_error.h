#pragma once
/// How far apart two motions carry a body's skin: what an eye sees of a fit's error.

#include "engine/core/result.h"
#include "engine/model/model.h"
#include "engine/model/motion.h"

namespace sinew {

/// The largest distance, in millimetres, between the places that `figure`'s vertices have at one frame of `a` and of
/// `b`, over all frames: both put onto it by retarget(), feet not lifted, and skinned. `figure` is a humanoid in
/// metres; the motions have one skeleton and as many frames. Fails as bad_input where the motion cannot be put onto a
/// humanoid.
Result<double> skin_error_mm(const Model& figure, const Motion& a, const Motion& b);

/// The same of the skeleton's own joints and bones' ends, for what is no humanoid.
double joint_error_mm(const Motion& a, const Motion& b);

}  // namespace sinew
