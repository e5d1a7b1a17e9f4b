#include "engine/rig/joint_tree.h"

#include <algorithm>
#include <cassert>

namespace sinew {

JointTree::JointTree(const Model& model, std::span<const Mat4> rest_global) {
  assert(rest_global.size() == model.nodes.size());
  const std::size_t count = model.nodes.size();
  parents_.reserve(count);
  positions_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    parents_.push_back(model.nodes[i].parent);
    positions_.push_back(Vec3(rest_global[i][3]));
    may_be_joint_.push_back(model.nodes[i].skin < 0);
  }
  for (std::size_t i = 0; i < count; ++i) {
    int depth = 0;
    for (int above = parents_[i]; above >= 0; above = parents_[above]) ++depth;
    depths_.push_back(depth);
  }
  is_joint_ = model.skins.empty() ? may_be_joint_ : std::vector<bool>(count, false);
  for (const Skin& skin : model.skins)
    for (const int joint : skin.joints) is_joint_[joint] = true;
  child_joints_.resize(count);
  for (int i = 0; i < size(); ++i) {
    if (!is_joint_[i]) continue;
    int above = parents_[i];
    while (above >= 0 && !is_joint_[above]) above = parents_[above];
    if (above >= 0) child_joints_[above].push_back(i);
  }
}

bool JointTree::is_below(int node, int ancestor) const {
  for (int above = parents_[node]; above >= 0; above = parents_[above])
    if (above == ancestor) return true;
  return false;
}

int JointTree::common_ancestor(int a, int b) const {
  while (a >= 0 && b >= 0 && a != b) {
    int& deeper = depths_[a] >= depths_[b] ? a : b;
    deeper = parents_[deeper];
  }
  return a == b ? a : -1;
}

std::vector<int> JointTree::between(int ancestor, int node) const {
  std::vector<int> path;
  if (!is_below(node, ancestor)) return path;
  for (int above = parents_[node]; above != ancestor; above = parents_[above]) path.push_back(above);
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace sinew
