#pragma once
/// Where a model's joints stand in the rest pose and which hangs from which.

#include <span>
#include <vector>

#include "engine/core/math.h"
#include "engine/model/model.h"

namespace sinew {

class JointTree {
 public:
  /// `rest_global`: [nodes] global rest transforms.
  JointTree(const Model& model, std::span<const Mat4> rest_global);

  int size() const { return static_cast<int>(parents_.size()); }
  int parent(int node) const { return parents_[node]; }
  int depth(int node) const { return depths_[node]; }
  const Vec3& position(int node) const { return positions_[node]; }
  double distance(int a, int b) const { return glm::length(positions_[a] - positions_[b]); }

  /// A node that may be a joint: it carries no skinned mesh.
  bool may_be_joint(int node) const { return may_be_joint_[node]; }
  /// A skin names it; in a model without skins every node that may be a joint is one.
  bool is_joint(int node) const { return is_joint_[node]; }
  /// The nearest joints below a node, in the file's order; nodes between that are no joints are skipped.
  const std::vector<int>& child_joints(int node) const { return child_joints_[node]; }

  /// True where `node` hangs from `ancestor`, at any depth; a node does not hang from itself.
  bool is_below(int node, int ancestor) const;
  /// The deepest node that both are, or hang from; -1 where there is none.
  int common_ancestor(int a, int b) const;
  /// The nodes from `ancestor` down to `node`, without these two; empty where `node` is not below `ancestor`.
  std::vector<int> between(int ancestor, int node) const;

 private:
  std::vector<int> parents_, depths_;
  std::vector<Vec3> positions_;
  std::vector<bool> may_be_joint_, is_joint_;
  std::vector<std::vector<int>> child_joints_;
};

}  // namespace sinew
