#include <algorithm>
#include <string>

#include "engine/motion/motion_blend.h"
#include "engine/rig/motion_rig.h"

namespace sinew {
namespace {

/// The name of the joint on the other side: the first side's word or letter in it exchanged; or the name itself.
std::string other_side(const std::string& name) {
  static const std::vector<std::pair<std::string, std::string>> words{
      {"Left", "Right"}, {"left", "right"}, {"LEFT", "RIGHT"}};
  for (const auto& [left, right] : words)
    for (const auto& [from, to] : {std::pair(left, right), std::pair(right, left)})
      if (const auto at = name.find(from); at != std::string::npos)
        return name.substr(0, at) + to + name.substr(at + from.size());
  const auto swapped = [](char c) { return c == 'L' ? 'R' : c == 'R' ? 'L' : c == 'l' ? 'r' : c == 'r' ? 'l' : '\0'; };
  std::string other = name;
  if (name.size() > 1) {
    // lHip, LHip, l_hip; hip.L, hip_l
    const char second = name[1], before_last = name[name.size() - 2];
    if (swapped(name[0]) != '\0' && (second == '_' || (second >= 'A' && second <= 'Z')))
      other[0] = swapped(name[0]);
    else if (swapped(name.back()) != '\0' && (before_last == '.' || before_last == '_'))
      other.back() = swapped(name.back());
  }
  return other;
}

/// [joints] which joint stands on the other side; itself where there is none.
std::vector<int> partners(const MotionSkeleton& skeleton, const Humanoid& humanoid) {
  const auto count = static_cast<int>(skeleton.joints.size());
  std::vector<int> partner(skeleton.joints.size());
  for (int j = 0; j < count; ++j) {
    partner[j] = j;
    const std::string wanted = other_side(skeleton.joints[j].name);
    for (int k = 0; k < count; ++k)
      if (skeleton.joints[k].name == wanted) partner[j] = k;
  }
  for (std::size_t bone = 0; bone < humanoid.node.size(); ++bone) {
    const int node = humanoid.node[bone];
    const int opposite = humanoid.find(mirrored_bone(static_cast<HumanoidBone>(bone)));
    if (node >= 0 && node < count && opposite >= 0 && opposite < count) partner[node] = opposite;
  }
  return partner;
}

}  // namespace

Motion mirrored(const Motion& motion) {
  const MotionRig rig = motion_rig(motion);
  const std::vector<int> partner = partners(motion.skeleton, rig.humanoid);
  const MotionPose rest = motion_rest(motion.skeleton);
  const Vec3 left = rig.rest_axes.left;
  // The mirror image of a turn is the turn about the mirrored axis, the other way round.
  const auto mirror = [&](const Quat& turn) {
    const Vec3 axis(turn.x, turn.y, turn.z);
    const Vec3 image = axis - 2.0 * glm::dot(axis, left) * left;
    return Quat(turn.w, -image.x, -image.y, -image.z);
  };
  Motion result = motion;
  for (std::size_t i = 0; i < motion.frames.size(); ++i) {
    const MotionPose pose = motion_pose(motion, i);
    MotionFrame& frame = result.frames[i];
    frame.root = motion.frames[i].root - 2.0 * glm::dot(motion.frames[i].root, left) * left;
    frame.offsets.clear();
    std::vector<Quat> global(partner.size());
    for (std::size_t j = 0; j < partner.size(); ++j) {
      const int from = partner[j];
      global[j] = mirror(pose.rotations[from] * glm::conjugate(rest.rotations[from])) * rest.rotations[j];
      const int parent = motion.skeleton.joints[j].parent;
      frame.rotations[j] = glm::normalize(parent < 0 ? global[j] : glm::conjugate(global[parent]) * global[j]);
    }
  }
  return result;
}

}  // namespace sinew
