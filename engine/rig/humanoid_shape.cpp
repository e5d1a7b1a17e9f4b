#include "engine/rig/humanoid_shape.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <span>
#include <utility>

namespace sinew {
namespace {

using enum HumanoidBone;

int node_of(const BoneNodes& bones, HumanoidBone bone) { return bones[index_of(bone)]; }

Vec3 without_part_along(const Vec3& v, const Vec3& unit) { return v - glm::dot(v, unit) * unit; }

/// The first of these bones that is there, or -1.
int first_present(const BoneNodes& bones, std::initializer_list<HumanoidBone> choices) {
  for (const HumanoidBone bone : choices)
    if (node_of(bones, bone) >= 0) return node_of(bones, bone);
  return -1;
}

/// Between the upper legs, or, where one is missing, the hips: a node named hips may stand off the legs.
std::optional<Vec3> pelvis_position(const JointTree& tree, const BoneNodes& bones) {
  const int left = node_of(bones, left_upper_leg), right = node_of(bones, right_upper_leg), hip = node_of(bones, hips);
  if (left >= 0 && right >= 0) return 0.5 * (tree.position(left) + tree.position(right));
  return hip >= 0 ? std::optional(tree.position(hip)) : std::nullopt;
}

/// From the right joint to the left one, zero where one is missing.
Vec3 right_to_left(const JointTree& tree, const BoneNodes& bones, HumanoidBone left) {
  const int l = node_of(bones, left), r = node_of(bones, mirrored_bone(left));
  return l >= 0 && r >= 0 ? tree.position(l) - tree.position(r) : Vec3(0.0);
}

/// A run of joints, each the only child of the one before; ends at a leaf or where it branches.
using Chain = std::vector<int>;

Chain chain_from(const JointTree& tree, int first) {
  Chain chain{first};
  while (tree.child_joints(chain.back()).size() == 1) chain.push_back(tree.child_joints(chain.back()).front());
  return chain;
}

double length_of(const JointTree& tree, const Chain& chain) {
  double length = 0.0;
  for (std::size_t i = 1; i < chain.size(); ++i) length += tree.distance(chain[i - 1], chain[i]);
  return length;
}

/// Both chains are images of each other in a plane through `root`. A rest pose is never quite symmetrical: 15 % of a
/// limb's length is let through.
bool mirrored(const JointTree& tree, int root, const Chain& a, const Chain& b) {
  if (a.size() != b.size() || a.size() < 3) return false;
  const double tolerance = 0.15 * std::min(length_of(tree, a), length_of(tree, b));
  const Vec3 across = tree.position(a.front()) - tree.position(b.front());
  if (tolerance <= 0.0 || glm::length(across) < 0.1 * tolerance) return false;
  const Vec3 normal = glm::normalize(across);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 between = tree.position(a[i]) - tree.position(b[i]);
    const Vec3 middle = 0.5 * (tree.position(a[i]) + tree.position(b[i])) - tree.position(root);
    if (glm::dot(between, normal) <= 0.0 || glm::length(without_part_along(between, normal)) > tolerance ||
        std::abs(glm::dot(middle, normal)) > tolerance)
      return false;
  }
  return true;
}

struct LimbPair {
  Chain a, b;
};

/// More joints than this hang from no hips or chest, but from the root of a crowd; all pairs are looked at.
constexpr std::size_t most_children = 64;

std::vector<LimbPair> limb_pairs(const JointTree& tree, int root) {
  std::vector<LimbPair> pairs;
  const std::vector<int>& children = tree.child_joints(root);
  if (children.size() > most_children) return pairs;
  for (std::size_t i = 0; i < children.size(); ++i)
    for (std::size_t j = i + 1; j < children.size(); ++j) {
      LimbPair pair{chain_from(tree, children[i]), chain_from(tree, children[j])};
      if (mirrored(tree, root, pair.a, pair.b)) pairs.push_back(std::move(pair));
    }
  return pairs;
}

/// The skeleton's trunk: two pairs of limbs and what joins them.
struct Trunk {
  int hips = -1, chest = -1;
  LimbPair legs, arms;
  Chain spine;  ///< above the hips, the chest included
  Chain head;   ///< above the chest
};

/// Follows a child of the hips up to the next joint with limbs.
std::optional<Trunk> follow_spine(const JointTree& tree, int hips, const LimbPair& legs, int first) {
  Trunk trunk{.hips = hips, .chest = first, .legs = legs, .arms = {}, .spine = {first}, .head = {}};
  std::vector<LimbPair> pairs = limb_pairs(tree, first);
  while (pairs.empty() && tree.child_joints(trunk.chest).size() == 1) {
    trunk.chest = tree.child_joints(trunk.chest).front();
    trunk.spine.push_back(trunk.chest);
    pairs = limb_pairs(tree, trunk.chest);
  }
  if (pairs.size() != 1 || tree.child_joints(trunk.chest).size() != 3) return std::nullopt;
  trunk.arms = pairs.front();
  for (const int child : tree.child_joints(trunk.chest))
    if (child != trunk.arms.a.front() && child != trunk.arms.b.front()) trunk.head = chain_from(tree, child);
  return trunk;
}

void set_limb(const Chain& chain, std::span<const HumanoidBone> limb, BoneNodes& bones) {
  for (std::size_t i = 0; i < std::min(limb.size(), chain.size()); ++i) bones[index_of(limb[i])] = chain[i];
}

/// How alike the two segments from the i-th joint on are in length, 1: equal. Upper and lower arm are, thigh and shin
/// too; a collarbone and an upper arm, or a forearm and a hand, are not.
double evenness(const JointTree& tree, const Chain& chain, std::size_t i) {
  const double first = tree.distance(chain[i], chain[i + 1]), second = tree.distance(chain[i + 1], chain[i + 2]);
  return std::min(first, second) / std::max({first, second, std::numeric_limits<double>::min()});
}

/// The index of the upper arm in an arm's chain: 0, or 1 behind a collarbone; nothing for lengths no arm has, or where
/// both would do.
std::optional<std::size_t> arm_start(const JointTree& tree, const Chain& chain) {
  const double at_0 = evenness(tree, chain, 0), at_1 = chain.size() >= 4 ? evenness(tree, chain, 1) : 0.0;
  if (std::max(at_0, at_1) < 0.5 || std::abs(at_0 - at_1) < 0.1) return std::nullopt;
  return at_0 > at_1 ? 0 : 1;
}

/// The bones of a trunk, its limbs `a` called left; nothing where a limb's segments do not fit.
std::optional<BoneNodes> bones_of(const JointTree& tree, const Trunk& trunk) {
  static constexpr std::array left_leg{left_upper_leg, left_lower_leg, left_foot, left_toes};
  static constexpr std::array right_leg{right_upper_leg, right_lower_leg, right_foot, right_toes};
  // What follows a hand is a finger, which shape alone cannot name.
  static constexpr std::array left_arm{left_shoulder, left_upper_arm, left_lower_arm, left_hand};
  static constexpr std::array right_arm{right_shoulder, right_upper_arm, right_lower_arm, right_hand};
  const auto arm = arm_start(tree, trunk.arms.a);
  if (!arm || evenness(tree, trunk.legs.a, 0) < 0.5 || trunk.legs.a.size() > 5 || trunk.arms.a.size() > *arm + 5)
    return std::nullopt;
  BoneNodes bones = no_bones();
  bones[index_of(hips)] = trunk.hips;
  assign_spine(tree, trunk.spine, bones);
  if (trunk.head.size() > 1) bones[index_of(neck)] = trunk.head[0];
  bones[index_of(head)] = trunk.head[trunk.head.size() > 1 ? 1 : 0];
  set_limb(trunk.legs.a, left_leg, bones);
  set_limb(trunk.legs.b, right_leg, bones);
  set_limb(trunk.arms.a, std::span(left_arm).subspan(1 - *arm), bones);
  set_limb(trunk.arms.b, std::span(right_arm).subspan(1 - *arm), bones);
  return bones;
}

double length_of_leg(const JointTree& tree, const BoneNodes& bones, HumanoidBone upper) {
  const int thigh = node_of(bones, upper), shin = node_of(bones, *next_on_chain(upper));
  const int foot = node_of(bones, *next_on_chain(*next_on_chain(upper)));
  return thigh < 0 || shin < 0 || foot < 0 ? 0.0 : tree.distance(thigh, shin) + tree.distance(shin, foot);
}

/// The two legs together, from their upper joints to the feet.
Vec3 along_legs(const JointTree& tree, const BoneNodes& bones) {
  return tree.position(node_of(bones, left_foot)) - tree.position(node_of(bones, left_upper_leg)) +
         tree.position(node_of(bones, right_foot)) - tree.position(node_of(bones, right_upper_leg));
}

/// Legs that go away from the head, and limbs of a length that goes with the trunk's: 0.3 to 3 times.
bool proportioned(const JointTree& tree, const BoneNodes& bones) {
  const double trunk = tree.distance(node_of(bones, hips), node_of(bones, head));
  const double arm = tree.distance(node_of(bones, left_upper_arm), node_of(bones, left_lower_arm)) +
                     tree.distance(node_of(bones, left_lower_arm), node_of(bones, left_hand));
  const double leg = length_of_leg(tree, bones, left_upper_leg);
  const Vec3 down = tree.position(node_of(bones, hips)) - tree.position(node_of(bones, head));
  return leg > 0.3 * trunk && leg < 3.0 * trunk && arm > 0.3 * trunk && arm < 3.0 * trunk &&
         angle_degrees(down, along_legs(tree, bones)) < 60.0;
}

}  // namespace

BoneNodes no_bones() {
  BoneNodes bones;
  bones.fill(-1);
  return bones;
}

void swap_sides(BoneNodes& bones, HumanoidBone first) {
  for (std::size_t i = index_of(first); i < humanoid_bone_count; ++i) {
    const std::size_t other = index_of(mirrored_bone(static_cast<HumanoidBone>(i)));
    if (i < other) std::swap(bones[i], bones[other]);
  }
}

BodyAxes body_axes(const JointTree& tree, const BoneNodes& bones) {
  const auto pelvis = pelvis_position(tree, bones);
  const int top = first_present(bones, {neck, head, upper_chest, chest, spine});
  const Vec3 up = unit_or(pelvis && top >= 0 ? tree.position(top) - *pelvis : Vec3(0.0), Vec3(0, 1, 0));
  const Vec3 across = right_to_left(tree, bones, left_upper_leg) + right_to_left(tree, bones, left_upper_arm);
  const Vec3 without_joints = unit_or(glm::cross(up, Vec3(0, 0, 1)), Vec3(1, 0, 0));
  const Vec3 left = unit_or(without_part_along(across, up), without_joints);
  return {up, left, glm::cross(left, up)};
}

double facing_evidence(const JointTree& tree, const BoneNodes& bones, const Vec3& up, const Vec3& front) {
  double evidence = 0.0;
  for (const HumanoidBone upper : {left_upper_leg, right_upper_leg}) {
    const HumanoidBone lower = *next_on_chain(upper), ankle = *next_on_chain(lower), toes = *next_on_chain(ankle);
    const int thigh = node_of(bones, upper), shin = node_of(bones, lower), foot = node_of(bones, ankle);
    if (foot < 0) continue;
    if (const int toe = node_of(bones, toes); toe >= 0)
      evidence += glm::dot(without_part_along(tree.position(toe) - tree.position(foot), up), front);
    if (thigh < 0 || shin < 0) continue;
    const Vec3 leg = unit_or(tree.position(foot) - tree.position(thigh), -up);
    evidence += glm::dot(without_part_along(tree.position(shin) - tree.position(thigh), leg), front);
  }
  return evidence;
}

double leg_length(const JointTree& tree, const BoneNodes& bones) {
  return std::max(length_of_leg(tree, bones, left_upper_leg), length_of_leg(tree, bones, right_upper_leg));
}

bool stands_on_four_legs(const JointTree& tree, const BoneNodes& bones) {
  const int top = first_present(bones, {neck, head}), hip = node_of(bones, hips);
  if (top < 0 || hip < 0) return false;
  for (const HumanoidBone bone : {left_upper_leg, left_foot, right_upper_leg, right_foot, left_hand, right_hand})
    if (node_of(bones, bone) < 0) return false;
  const Vec3 legs = along_legs(tree, bones);
  const Vec3 down = unit_or(legs, Vec3(0, -1, 0));
  // A human's spine continues the legs within 50 degrees unless he bends or sits, and then his hands do not reach the
  // level of the feet; a third of a leg is what a paw's wrist may stand higher than the hind foot.
  const bool level = angle_degrees(tree.position(top) - tree.position(hip), -legs) > 50.0;
  const auto height_over_foot = [&](HumanoidBone hand, HumanoidBone foot) {
    return glm::dot(tree.position(node_of(bones, foot)) - tree.position(node_of(bones, hand)), down);
  };
  const double reach = glm::length(legs) / 2.0 / 3.0;
  return level && height_over_foot(left_hand, left_foot) < reach && height_over_foot(right_hand, right_foot) < reach;
}

void assign_spine(const JointTree& tree, const std::vector<int>& joints, BoneNodes& bones) {
  for (const HumanoidBone bone : {spine, chest, upper_chest}) bones[index_of(bone)] = -1;
  if (joints.empty()) return;
  bones[index_of(spine)] = joints.front();
  if (joints.size() == 2) bones[index_of(chest)] = joints.back();
  if (joints.size() < 3) return;
  bones[index_of(upper_chest)] = joints.back();
  const auto off_the_middle = [&](int joint) {
    return std::abs(tree.distance(joint, joints.front()) - tree.distance(joint, joints.back()));
  };
  bones[index_of(chest)] = *std::min_element(joints.begin() + 1, joints.end() - 1,
                                             [&](int a, int b) { return off_the_middle(a) < off_the_middle(b); });
}

std::optional<ShapeFinding> find_by_shape(const JointTree& tree) {
  std::vector<ShapeFinding> found;
  for (int root = 0; root < tree.size(); ++root) {
    if (!tree.is_joint(root) || tree.child_joints(root).size() < 3) continue;
    const std::vector<LimbPair> legs = limb_pairs(tree, root);
    if (legs.size() != 1) continue;
    for (const int child : tree.child_joints(root)) {
      if (child == legs[0].a.front() || child == legs[0].b.front()) continue;
      const auto trunk = follow_spine(tree, root, legs[0], child);
      const auto bones = trunk ? bones_of(tree, *trunk) : std::nullopt;
      if (!bones) continue;
      const bool four_legs = stands_on_four_legs(tree, *bones);
      if (four_legs || proportioned(tree, *bones)) found.push_back({*bones, four_legs});
    }
  }
  if (found.size() != 1) return std::nullopt;
  ShapeFinding& only = found.front();
  const BodyAxes axes = body_axes(tree, only.bones);
  const double evidence = facing_evidence(tree, only.bones, axes.up, axes.front);
  if (!only.four_legs && std::abs(evidence) < 0.02 * leg_length(tree, only.bones)) return std::nullopt;
  if (evidence < 0.0) swap_sides(only.bones);
  return only;
}

}  // namespace sinew
