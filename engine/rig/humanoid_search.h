#pragma once
/// The humanoid bones as the joints' names give them, each checked against the hierarchy and the rest pose.

#include <string>
#include <vector>

#include "engine/model/model.h"
#include "engine/rig/humanoid_bone.h"
#include "engine/rig/joint_tree.h"

namespace sinew {

/// A node for messages: its name in quotes, or its index where it has none.
std::string called(const Model& model, int node);

/// What names tell. A limb's joints hang from one another; a hand or foot that hangs elsewhere (from an IK root) is
/// taken where it stands at the limb's end. Says in `notes` what was decided against the first look of a name.
BoneNodes find_by_names(const Model& model, const JointTree& tree, std::vector<std::string>& notes);

}  // namespace sinew
