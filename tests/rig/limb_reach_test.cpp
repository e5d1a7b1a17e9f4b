#include "engine/rig/limb_reach.h"

#include <map>
#include <random>

#include <gtest/gtest.h>

#include "engine/body/built_in_model.h"
#include "engine/rig/pose.h"

namespace sinew::test {
namespace {

using enum HumanoidBone;

/// A character whose joints are turned by keys.
struct Puppet {
  Model model;
  std::vector<int> order;
  std::vector<Quat> rest_rotations;
  std::vector<Mat4> rest, global;
  Humanoid humanoid;
  std::map<int, Vec3> keys;  ///< node -> degrees

  explicit Puppet(const char* name) : model(*built_in_model(name)) {
    order = hierarchy_order(model);
    rest_rotations = sinew::rest_rotations(model, order);
    rest = global_transforms(model, order, rest_pose(model));
    humanoid = find_humanoid(model, rest);
    pose();
  }
  void pose() {
    Pose posed = rest_pose(model);
    for (const auto& [node, degrees] : keys) turn_joint(model, rest_rotations, node, degrees, posed);
    global = global_transforms(model, order, posed);
  }
  Vec3 place(int node) const { return Vec3(global[static_cast<std::size_t>(node)][3]); }
  TurnedJoint joint(int node) {
    const auto parent = static_cast<std::size_t>(model.nodes[static_cast<std::size_t>(node)].parent);
    const Quat posed = glm::quat_cast(Mat3(global[parent]));
    return {posed * glm::conjugate(rest_rotations[parent]), rotation_xyz_degrees(keys[node]), place(node)};
  }
  Limb limb(HumanoidBone end) const { return *find_limb(model, humanoid, rest, end); }
  void reach_for(const Limb& limb, const Vec3& target) {
    const LimbTurns turns = reach(limb, joint(limb.upper), joint(limb.lower), place(limb.end), target);
    keys[limb.upper] = key_degrees(turns.upper, keys[limb.upper]);
    keys[limb.lower] = key_degrees(turns.lower, keys[limb.lower]);
    pose();
  }
  double length(const Limb& limb) const {
    return glm::distance(place(limb.upper), place(limb.lower)) + glm::distance(place(limb.lower), place(limb.end));
  }
};

TEST(JointLimits, ElbowsAndKneesCloseTheWayPeoplesDo) {
  for (const char* name : {"builtin:woman", "builtin:figure", "builtin:poser"})
    for (const HumanoidBone end : {left_hand, right_hand, left_foot, right_foot}) {
      SCOPED_TRACE(name + std::string(humanoid_name(end)));
      Puppet puppet(name);
      const Limb limb = puppet.limb(end);
      const bool arm = end == left_hand || end == right_hand;
      const Vec3 before = puppet.place(limb.end);
      puppet.keys[limb.lower] =
          key_degrees(glm::angleAxis(60.0 * degrees_to_radians, limb.lower_limits.bend), Vec3(0.0));
      puppet.pose();
      EXPECT_GT((puppet.place(limb.end) - before).z * (arm ? 1.0 : -1.0), 0.05) << "hands forward, feet back";
    }
}

TEST(JointLimits, HoldsEachOfTheThree) {
  const Puppet puppet("builtin:woman");
  const JointLimits limits =
      *joint_limits(puppet.model, puppet.humanoid, puppet.rest, puppet.humanoid.find(left_lower_arm));
  EXPECT_TRUE(is_within(limits, Quat(1, 0, 0, 0)));
  std::mt19937 random(3);
  std::normal_distribution<double> number;
  for (int i = 0; i < 500; ++i) {
    const Quat turn = glm::normalize(Quat(number(random), number(random), number(random), number(random)));
    const Quat held = hold_turn(limits, turn);
    EXPECT_TRUE(is_within(limits, held));
    if (is_within(limits, turn)) {
      EXPECT_NEAR(std::abs(glm::dot(held, turn)), 1.0, 1e-9);
    }
  }
  const Quat far = hold_turn(limits, glm::angleAxis(170.0 * degrees_to_radians, limits.bend));
  EXPECT_NEAR(glm::angle(far) * radians_to_degrees, limits.bend_degrees.high, 1e-6);
}

TEST(JointLimits, NumbersOfAKeyHaveTheirRange) {
  const Puppet puppet("builtin:woman");
  const int elbow = puppet.humanoid.find(left_lower_arm);
  const JointLimits limits = *joint_limits(puppet.model, puppet.humanoid, puppet.rest, elbow);
  for (int axis = 0; axis < 3; ++axis) {
    const DegreeRange range = number_range(limits, Vec3(0.0), axis);
    Vec3 inside(0.0), outside(0.0);
    inside[axis] = range.high;
    outside[axis] = range.high + 1.0;
    EXPECT_TRUE(is_within(limits, rotation_xyz_degrees(inside)));
    EXPECT_FALSE(is_within(limits, rotation_xyz_degrees(outside)));
  }
  EXPECT_EQ(number_range(limits, Vec3(0, 0, 170), 0), DegreeRange{}) << "what is beyond already may go anywhere";
  EXPECT_FALSE(joint_limits(puppet.model, puppet.humanoid, puppet.rest, puppet.humanoid.find(hips)));
}

TEST(JointLimits, KeysAreTheNearestThatMakeATurn) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> degrees(-250.0, 250.0);
  for (int i = 0; i < 500; ++i) {
    const Vec3 key(degrees(random), degrees(random), degrees(random));
    const Vec3 again = key_degrees(rotation_xyz_degrees(key), key);
    EXPECT_LT(glm::distance(key, again), 1e-6) << "itself";
  }
}

TEST(LimbReach, ReachesWhatItCan) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0.45, 0.98), angle(-1.0, 1.0);
  Puppet puppet("builtin:woman");
  for (const HumanoidBone end : {left_hand, right_hand, left_foot, right_foot})
    for (int i = 0; i < 50; ++i) {
      SCOPED_TRACE(humanoid_name(end));
      puppet.keys.clear();
      puppet.pose();
      Limb limb = puppet.limb(end);
      limb.upper_limits.bend_degrees = limb.upper_limits.side_degrees = limb.upper_limits.twist_degrees = {};
      const Vec3 direction =
          glm::normalize(limb.upper_limits.along + 0.8 * Vec3(angle(random), angle(random), angle(random)));
      const Vec3 target = puppet.place(limb.upper) + share(random) * puppet.length(limb) * direction;
      puppet.reach_for(limb, target);
      EXPECT_LT(glm::distance(puppet.place(limb.end), target), 1e-9);
      EXPECT_TRUE(is_within(limb.lower_limits, rotation_xyz_degrees(puppet.keys[limb.lower])));
    }
}

TEST(LimbReach, IsStraightTowardsWhatItCannotReach) {
  for (const HumanoidBone end : {left_hand, right_foot}) {
    Puppet puppet("builtin:woman");
    const Limb limb = puppet.limb(end);
    const Vec3 root = puppet.place(limb.upper);
    const Vec3 target = root + 3.0 * puppet.length(limb) * glm::normalize(limb.upper_limits.along + Vec3(0, 0, 0.3));
    puppet.reach_for(limb, target);
    EXPECT_LT(angle_degrees(puppet.place(limb.end) - root, target - root), 1e-6);
    // A rest pose's elbow may stand a little out of the hinge's plane.
    EXPECT_GT(glm::distance(puppet.place(limb.end), root), 0.995 * puppet.length(limb));
  }
}

TEST(LimbReach, KeepsTheLimits) {
  std::mt19937 random(13);
  std::normal_distribution<double> number;
  for (const HumanoidBone end : {left_hand, right_hand, left_foot, right_foot}) {
    Puppet puppet("builtin:woman");
    const Limb limb = puppet.limb(end);
    for (int i = 0; i < 100; ++i) {
      const Vec3 way(number(random), number(random), number(random));
      puppet.reach_for(limb, puppet.place(limb.upper) + 0.5 * puppet.length(limb) * way);
      EXPECT_TRUE(is_within(limb.upper_limits, rotation_xyz_degrees(puppet.keys[limb.upper])));
      EXPECT_TRUE(is_within(limb.lower_limits, rotation_xyz_degrees(puppet.keys[limb.lower])));
    }
  }
}

TEST(LimbReach, KeepsTheForearmsTwist) {
  Puppet puppet("builtin:woman");
  const Limb limb = puppet.limb(left_hand);
  puppet.keys[limb.lower] = key_degrees(glm::angleAxis(0.7, limb.lower_limits.along), Vec3(0.0));
  puppet.pose();
  const Vec3 root = puppet.place(limb.upper);
  puppet.reach_for(limb, root + 0.8 * (puppet.place(limb.end) - root));
  const Quat turn = rotation_xyz_degrees(puppet.keys[limb.lower]);
  const Vec3 v(turn.x, turn.y, turn.z);
  EXPECT_NEAR(2.0 * std::atan2(glm::dot(v, limb.lower_limits.along), turn.w), 0.7, 1e-6);
}

TEST(LimbReach, AnArmThatIsNotThereIsNoLimb) {
  const Puppet puppet("builtin:arm");
  EXPECT_FALSE(find_limb(puppet.model, puppet.humanoid, puppet.rest, right_hand));
  EXPECT_FALSE(find_limb(puppet.model, puppet.humanoid, puppet.rest, hips));
}

}  // namespace
}  // namespace sinew::test
