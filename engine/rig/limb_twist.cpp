#include "engine/rig/limb_twist.h"

#include "engine/core/text.h"
#include "engine/rig/joint_tree.h"
#include "engine/rig/rest_alignment.h"

namespace sinew {
namespace {

using enum HumanoidBone;

struct Segment {
  HumanoidBone bone, next;
  bool upper;
};

constexpr Segment segments[] = {
    {left_upper_arm, left_lower_arm, true},   {left_lower_arm, left_hand, false},
    {right_upper_arm, right_lower_arm, true}, {right_lower_arm, right_hand, false},
    {left_upper_leg, left_lower_leg, true},   {left_lower_leg, left_foot, false},
    {right_upper_leg, right_lower_leg, true}, {right_lower_leg, right_foot, false},
};

bool says_twist(const std::string& name) { return lower(name).find("twist") != std::string::npos; }

std::size_t at(int node) { return static_cast<std::size_t>(node); }

}  // namespace

std::vector<TwistSegment> twist_segments(const Model& model, const Humanoid& humanoid,
                                         std::span<const Mat4> rest_global) {
  const JointTree tree(model, rest_global);
  std::vector<TwistSegment> found;
  for (const Segment& segment : segments) {
    TwistSegment twist;
    twist.bone = humanoid.find(segment.bone);
    twist.next = humanoid.find(segment.next);
    twist.upper = segment.upper;
    if (twist.bone < 0 || twist.next < 0 || !tree.is_below(twist.next, twist.bone)) continue;
    const Vec3 start = tree.position(twist.bone), along = tree.position(twist.next) - start;
    const double length = glm::length(along);
    if (length == 0.0) continue;
    const auto share = [&](int node) { return glm::dot(tree.position(node) - start, along) / (length * length); };
    const auto on_axis = [&](int node) {
      const Vec3 off = tree.position(node) - start - share(node) * along;
      return share(node) > 0.02 && share(node) < 0.98 && glm::length(off) < 0.15 * length;
    };
    for (const int node : tree.between(twist.bone, twist.next))
      if (on_axis(node)) twist.between.push_back(node);
    for (const int child : tree.child_joints(twist.bone))
      if (says_twist(model.nodes[at(child)].name) && tree.child_joints(child).empty() && child != twist.next)
        twist.leaves.push_back({child, std::clamp(share(child), 0.0, 1.0)});
    if (!twist.between.empty() || !twist.leaves.empty()) found.push_back(std::move(twist));
  }
  return found;
}

double twist_degrees(const Quat& rotation, const Vec3& axis) {
  Quat q = rotation;
  if (q.w < 0.0) q = -q;
  const double along = glm::dot(Vec3(q.x, q.y, q.z), axis);
  const double size = std::hypot(q.w, along);
  // |(w, along)| is the cosine of half the swing: at half a turn of it, no twist is defined.
  const double twist = 2.0 * std::atan2(along, q.w) * radians_to_degrees;
  const double swing = 2.0 * std::acos(std::min(size, 1.0)) * radians_to_degrees;
  constexpr double fade = 40.0;  // degrees before half a turn
  return twist * smoothstep01((180.0 - std::abs(twist)) / fade) * smoothstep01((180.0 - swing) / fade);
}

void share_twist(const Model& model, const TwistSegment& segment, std::span<const Quat> rest,
                 std::span<const Mat4> rest_global, std::span<Quat> rotations) {
  const Vec3 along = unit_or(Vec3(rest_global[at(segment.next)][3] - rest_global[at(segment.bone)][3]), Vec3(0, 1, 0));
  // What the twisting joint would do if it only followed the one above it.
  const int twisting = segment.upper ? segment.bone : segment.next;
  const int above = segment.upper ? model.nodes[at(segment.bone)].parent : segment.bone;
  const Quat parent_turn = above >= 0 ? rotations[at(above)] * glm::conjugate(rest[at(above)]) : Quat(1, 0, 0, 0);
  const Quat turn = rotations[at(twisting)] * glm::conjugate(rest[at(twisting)]);
  // In rest coordinates, where the segment's axis is `along`.
  const double twist = twist_degrees(glm::normalize(glm::conjugate(parent_turn) * turn), along) * degrees_to_radians;
  const Quat bone = rotations[at(segment.bone)];
  const Vec3 axis = bone * (glm::conjugate(rest[at(segment.bone)]) * along);
  const auto turned = [&](int node, double radians) {
    const Quat follows = bone * glm::conjugate(rest[at(segment.bone)]) * rest[at(node)];
    return glm::normalize(glm::angleAxis(radians, axis) * follows);
  };
  const double n = static_cast<double>(segment.between.size());
  // Equal steps: of an upper limb over its joint and the twist joints, of a lower one also over the joint at its end.
  const double steps = segment.upper ? n + 1.0 : n + 2.0;
  const double missing = segment.upper ? twist : 0.0;
  for (std::size_t i = 0; i < segment.between.size(); ++i)
    rotations[at(segment.between[i])] =
        turned(segment.between[i], twist * static_cast<double>(i + 2) / steps - missing);
  for (const TwistSegment::Leaf& leaf : segment.leaves)
    rotations[at(leaf.node)] = turned(leaf.node, twist * leaf.at - missing);
  if (segment.between.empty()) return;
  rotations[at(segment.bone)] = turned(segment.bone, twist / steps - missing);
  // Twist joints beside the axis carry what is after them round it: the whole is turned back to where it pointed.
  Vec3 reached(0.0);
  std::vector<int> path{segment.bone};
  path.insert(path.end(), segment.between.begin(), segment.between.end());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const int end = i + 1 < path.size() ? path[i + 1] : segment.next;
    const Vec3 step(rest_global[at(end)][3] - rest_global[at(path[i])][3]);
    reached += rotations[at(path[i])] * (glm::conjugate(rest[at(path[i])]) * step);
  }
  const Quat back = turn_between(reached, axis);
  for (const int node : path) rotations[at(node)] = glm::normalize(back * rotations[at(node)]);
}

}  // namespace sinew
