#include "engine/rig/joint_matching.h"

#include <algorithm>

#include "engine/rig/motion_rig.h"

namespace sinew {
namespace {

using enum HumanoidBone;

/// Chains of any two numbers of joints, matched so that the last follows the last. `before`: the joint below both.
void follow_chain(const std::vector<int>& nodes, const std::vector<int>& joints, int before,
                  std::vector<JointFollow>& follows) {
  if (nodes.empty() || joints.empty()) return;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double place = static_cast<double>((i + 1) * joints.size()) / static_cast<double>(nodes.size());
    const auto whole = static_cast<std::size_t>(place + 1e-9);
    const double share = place - static_cast<double>(whole);
    const int first = whole == 0 ? before : joints[whole - 1];
    if (share < 1e-6 || whole >= joints.size())
      follows.push_back({nodes[i], first, -1, 0.0});
    else
      follows.push_back({nodes[i], first, joints[whole], share});
  }
}

/// Joints from above the hips up to below the neck, or the head where there is no neck.
std::vector<int> trunk_of(const Model& model, const Humanoid& humanoid) {
  const HumanoidBone top = humanoid.find(neck) >= 0 ? neck : head;
  std::vector<int> chain = joints_between(model, humanoid, hips, top);
  if (!chain.empty()) chain.pop_back();
  // A trunk that does not hang from the hips has its humanoid bones alone.
  if (chain.empty())
    for (const HumanoidBone bone : {spine, chest, upper_chest})
      if (humanoid.find(bone) >= 0) chain.push_back(humanoid.find(bone));
  return chain;
}

std::vector<int> neck_of(const Model& model, const Humanoid& humanoid) {
  if (humanoid.find(head) < 0) return {};
  if (humanoid.find(neck) < 0) return {humanoid.find(head)};
  std::vector<int> chain = joints_between(model, humanoid, neck, head);
  if (chain.empty()) chain.push_back(humanoid.find(head));
  chain.insert(chain.begin(), humanoid.find(neck));
  return chain;
}

}  // namespace

std::vector<JointFollow> match_joints(const Model& model, const Humanoid& humanoid, std::span<const int> order,
                                      const Model& skeleton, const Humanoid& skeleton_humanoid) {
  const int node_hips = humanoid.find(hips), joint_hips = skeleton_humanoid.find(hips);
  if (node_hips < 0 || joint_hips < 0) return {};
  std::vector<JointFollow> follows{{node_hips, joint_hips, -1, 0.0}};
  const std::vector<int> trunk = trunk_of(skeleton, skeleton_humanoid);
  follow_chain(trunk_of(model, humanoid), trunk, joint_hips, follows);
  follow_chain(neck_of(model, humanoid), neck_of(skeleton, skeleton_humanoid),
               trunk.empty() ? joint_hips : trunk.back(), follows);
  for (std::size_t i = index_of(jaw); i < humanoid_bone_count; ++i)
    if (humanoid.node[i] >= 0 && skeleton_humanoid.node[i] >= 0)
      follows.push_back({humanoid.node[i], skeleton_humanoid.node[i], -1, 0.0});
  std::vector<std::size_t> rank(model.nodes.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[static_cast<std::size_t>(order[i])] = i;
  std::stable_sort(follows.begin(), follows.end(), [&](const JointFollow& a, const JointFollow& b) {
    return rank[static_cast<std::size_t>(a.node)] < rank[static_cast<std::size_t>(b.node)];
  });
  return follows;
}

}  // namespace sinew
