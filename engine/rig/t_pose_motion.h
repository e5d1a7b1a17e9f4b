#pragma once
/// A motion on the skeleton that VRM animations have: the humanoid bones alone, at rest in the T pose of VRM 1.0.

#include "engine/core/result.h"
#include "engine/model/model.h"
#include "engine/model/motion.h"
#include "engine/rig/humanoid.h"

namespace sinew {

struct TPoseMotion {
  Model model;        ///< a node a bone, named as VRM names it, rest rotations identity, metres; clips: the motion
  Humanoid humanoid;  ///< of it; without eyes, which VRM animations move otherwise
};

/// The motion's own skeleton stood up, put into the T pose and scaled to metres, and the motion on it. Fails as
/// bad_input where the motion lacks a bone that VRM requires.
Result<TPoseMotion> t_pose_motion(const Motion& motion);

}  // namespace sinew
