#pragma once
/// A character's joints as the viewer lists and calls them. No interface here.

#include <string>
#include <vector>

#include "engine/app/stage.h"

namespace sinew {

/// Joints of a character in the order of its hierarchy, with how deep each lies.
struct ListedJoint {
  std::string name;   ///< what the scene's keys call it, else the node's name
  std::string shown;  ///< the node's name, the humanoid name beside it where it has one
  int depth = 0;
  int node = -1;
};
std::vector<ListedJoint> listed_joints(const StagedCharacter& character);

/// What the scene calls the joint that a name of any kind means, so that it has one track alone; the name itself where
/// the character has no such joint.
std::string called_joint(const StagedCharacter& character, const std::string& name);

/// What the scene calls a node of the character; empty where it is no joint with a name.
std::string joint_name(const StagedCharacter& character, int node);

}  // namespace sinew
