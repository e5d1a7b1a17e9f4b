#pragma once
/// A motion put onto another body (engine/definitions.md 13).

#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/model/model.h"
#include "engine/model/motion.h"
#include "engine/rig/humanoid.h"

namespace sinew {

struct RetargetOptions {
  bool lift_feet = true;        ///< raise the body where its feet would sink into the floor
  bool from_rest_place = true;  ///< begin with the hips over where they rest; else where the file has them, scaled
};

struct Retargeted {
  Clip clip;                     ///< the motion as an animation of the model: rotations, and the hips' translation
  double scale = 1.0;            ///< from the file's lengths to the model's: the ratio of the hips' heights
  double deepest_sinking = 0.0;  ///< how far the lowest foot is under the floor at the worst frame, before lifting
  std::size_t deepest_frame = 0;
  std::vector<std::string> notes;  ///< for people
};

/// Turns the motion into a clip of the model. Its rest limbs are first turned onto the motion's own, so that T, A and
/// bent rest poses give the same limbs; then every joint turns in the world as the motion's does. Trunk and neck are
/// matched along their lengths, whatever the number of joints; twist is shared among twist joints; what the motion
/// lacks keeps to its parent. The hips' path is scaled by the ratio of hip heights, level with the model's floor: a
/// quarter of the frames have a foot lower, and where `lift_feet`, those are raised smoothly. Fails as bad_input where
/// either body has no hips, or they have no limb in common.
Result<Retargeted> retarget(const Motion& motion, const Model& model, const Humanoid& humanoid,
                            const RetargetOptions& options = {});

}  // namespace sinew
