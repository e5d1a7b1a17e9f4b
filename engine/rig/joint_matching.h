#pragma once
/// Which joints of a motion lead which nodes of a model.

#include <span>
#include <vector>

#include "engine/model/model.h"
#include "engine/rig/humanoid.h"

namespace sinew {

/// What a node of the model turns like: one joint of the motion, or between two.
struct JointFollow {
  int node = -1;
  int first = -1, second = -1;  ///< joints; second -1: the first alone
  double share = 0.0;           ///< of the second
};

/// Hips, limbs, fingers and jaw by their humanoid bones; trunk and neck along their lengths, whatever the number of
/// joints, so that the last follows the last. Parents stand before their children. Empty where either has no hips.
/// `order`: hierarchy_order(model); `skeleton`: of the motion.
std::vector<JointFollow> match_joints(const Model& model, const Humanoid& humanoid, std::span<const int> order,
                                      const Model& skeleton, const Humanoid& skeleton_humanoid);

}  // namespace sinew
