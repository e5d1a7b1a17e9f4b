#pragma once
/// Bones that were found in examples, as a skeleton with a clip.

#include <span>

#include "engine/fit/rigid_bones.h"
#include "engine/model/model.h"

namespace sinew {

/// One root joint with a joint for each bone below it, at rest in the middle of what follows the bone, and the clip
/// "found" that moves them: a key a pose, at `seconds` (strictly rising). The model draws nothing yet.
Model found_skeleton(const RigidBones& found, std::span<const Vec3> rest, std::span<const double> seconds);

}  // namespace sinew
