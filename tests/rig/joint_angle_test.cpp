#include "engine/rig/joint_angle.h"

#include <gtest/gtest.h>

#include "tests/rig/humanoid_skeletons.h"

namespace sinew::test {
namespace {

/// Roundings of an angle in degrees.
constexpr double rounding = 1e-12;

std::vector<Mat4> at_places(const std::vector<Vec3>& places) {
  std::vector<Mat4> global;
  for (const Vec3& p : places) global.push_back(Transform{p}.matrix());
  return global;
}

TEST(JointAngle, IsTheAngleOfTheTriangleAtItsMiddle) {
  const JointAngle angle{2, 0, 1};
  EXPECT_NEAR(angle.degrees(at_places({{0, 0, 0}, {0, 0, 3}, {0, 2, 0}})), 90.0, rounding);
  EXPECT_NEAR(angle.degrees(at_places({{1, 1, 1}, {2, 1, 1}, {2, 2, 1}})), 45.0, rounding);
  EXPECT_NEAR(angle.degrees(at_places({{1, 0, 0}, {5, 0, 0}, {-1, 0, 0}})), 180.0, rounding);
  EXPECT_NEAR(angle.degrees(at_places({{1, 0, 0}, {5, 0, 0}, {2, 0, 0}})), 0.0, rounding);
  // The law of cosines on the triangle of sides 3, 5, 7: 120 degrees between 3 and 5.
  EXPECT_NEAR(angle.degrees(at_places({{0, 0, 0}, {3, 0, 0}, {-2.5, 5 * std::sqrt(0.75), 0}})), 120.0, rounding);
}

TEST(JointAngle, DoesNotChangeWithRigidMotionOrUniformScale) {
  const std::vector<Mat4> here = at_places({{0.1, 0.2, 0.3}, {1, -2, 0.5}, {-0.4, 0.9, 2}});
  const JointAngle angle{0, 1, 2};
  const Mat4 motion = Transform{{4, 5, 6}, rotation_xyz_degrees({20, 70, -130}), Vec3(3)}.matrix();
  std::vector<Mat4> there;
  for (const Mat4& m : here) there.push_back(motion * m);
  EXPECT_NEAR(angle.degrees(there), angle.degrees(here), rounding);
}

TEST(DriverAngle, GoesAlongTheHumanoidChainPastTwistJoints) {
  Skeleton skeleton = build(convention("VRM"));
  Model& model = skeleton.model;
  const auto node = [&](const char* name) {
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
      if (model.nodes[i].name == name) return static_cast<int>(i);
    ADD_FAILURE() << name;
    return -1;
  };
  // Twist joints between shoulder, elbow and wrist, and one that is the elbow's first child.
  const int arm_twist = skeleton.add("armTwist", node("leftUpperArm"), {0.3, 1.43, 0});
  const int fore_twist = skeleton.add("foreTwist", node("leftLowerArm"), {0.6, 1.43, 0});
  model.nodes[node("leftLowerArm")].parent = arm_twist;
  model.nodes[node("leftHand")].parent = fore_twist;
  link_children(model);
  const Humanoid humanoid = find_humanoid(model, rest_transforms(model));
  const int elbow = node("leftLowerArm");
  const auto found = driver_angle(model, humanoid, elbow);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->at, elbow);
  EXPECT_EQ(found->before, node("leftUpperArm"));
  EXPECT_EQ(found->after, node("leftHand"));
  const auto with_tip = driver_angle(model, humanoid, elbow, fore_twist);
  ASSERT_TRUE(with_tip);
  EXPECT_EQ(with_tip->after, fore_twist);
  EXPECT_EQ(with_tip->before, node("leftUpperArm"));
  // The joint of a twist is no humanoid bone: its parent and its child are its neighbours.
  const auto twist = driver_angle(model, humanoid, arm_twist);
  ASSERT_TRUE(twist);
  EXPECT_EQ(twist->before, node("leftUpperArm"));
  EXPECT_EQ(twist->after, elbow);
  const auto foot = driver_angle(model, humanoid, node("leftFoot"));
  ASSERT_TRUE(foot);
  EXPECT_EQ(foot->before, node("leftLowerLeg"));
  EXPECT_EQ(foot->after, node("leftToes"));
}

TEST(DriverAngle, WithoutAHumanoidItIsTheParentAndTheFirstChild) {
  Model model;
  model.nodes.resize(5);
  model.nodes[1].parent = 0;
  model.nodes[2].parent = model.nodes[3].parent = 1;
  model.nodes[4].parent = 3;
  link_children(model);
  const Humanoid none;
  const auto found = driver_angle(model, none, 1);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->before, 0);
  EXPECT_EQ(found->after, 2);
  EXPECT_EQ(driver_angle(model, none, 1, 4)->after, 4);
  EXPECT_FALSE(driver_angle(model, none, 0)) << "nothing before the root";
  EXPECT_FALSE(driver_angle(model, none, 0, 4));
  EXPECT_FALSE(driver_angle(model, none, 2)) << "nothing after a leaf";
  EXPECT_TRUE(driver_angle(model, none, 2, 4));
}

TEST(MuscleActivation, IsTheRatioOfTheFlexions) {
  EXPECT_EQ(muscle_activation(170, 170, 50), 0.0);
  EXPECT_EQ(muscle_activation(50, 170, 50), 1.0);
  EXPECT_EQ(muscle_activation(110, 170, 50), 0.5);
  EXPECT_EQ(muscle_activation(20, 170, 50), 1.25) << "it goes on beyond the reference";
  EXPECT_EQ(muscle_activation(175, 170, 50), 0.0) << "but never below 0";
}

TEST(MuscleActivation, ServesWhereTheReferenceIsTheLargerAngle) {
  EXPECT_EQ(muscle_activation(115, 115, 150), 0.0);
  EXPECT_EQ(muscle_activation(150, 115, 150), 1.0);
  EXPECT_EQ(muscle_activation(132.5, 115, 150), 0.5);
  EXPECT_EQ(muscle_activation(100, 115, 150), 0.0);
}

TEST(MuscleActivation, OfAMuscleThatIsOffIsNothing) {
  Muscle muscle;
  muscle.rest_angle = 180.0;
  muscle.reference_angle = 60.0;
  EXPECT_EQ(muscle_activation(muscle, 90.0), muscle_activation(90.0, 180.0, 60.0));
  muscle.on = false;
  for (const double angle : {0.0, 60.0, 90.0, 180.0}) EXPECT_EQ(muscle_activation(muscle, angle), 0.0);
}

TEST(MuscleActivation, BelowABillionthIsNothing) {
  EXPECT_EQ(muscle_activation(180 - 0.9e-7, 180, 80), 0.0);
  EXPECT_GT(muscle_activation(180 - 1.1e-7, 180, 80), 1e-9);
  EXPECT_EQ(muscle_activation(100 + 0.9e-7, 100, 200), 0.0);
  EXPECT_FALSE(std::signbit(muscle_activation(180, 170, 50)));
}

}  // namespace
}  // namespace sinew::test
