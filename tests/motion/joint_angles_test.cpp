#include "engine/motion/joint_angles.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

/// From the paper's left-handed row vectors to our right-handed columns and back: z reversed.
Vec3 turned_as_in_the_paper(const Vec3& v, const Vec3& degrees) {
  const Vec3 mirrored = rotation_of_angles(degrees * degrees_to_radians) * Vec3(v.x, v.y, -v.z);
  return {mirrored.x, mirrored.y, -mirrored.z};
}

TEST(JointAngles, AreEquation6) {
  // v T by the paper's three matrices, worked out by hand.
  const Vec3 v = turned_as_in_the_paper({1, 2, 3}, {30, 20, 10});
  EXPECT_NEAR(v.x, 1.625125, 1e-6);
  EXPECT_NEAR(v.y, 0.555603, 1e-6);
  EXPECT_NEAR(v.z, 3.324195, 1e-6);
}

TEST(JointAngles, ComeBack) {
  for (const EulerOrder& order : {EulerOrder{0, 1, 2}, EulerOrder{2, 0, 1}, EulerOrder{1, 2, 0}, EulerOrder{2, 1, 0}}) {
    const Vec3 angles(0.4, -0.7, 1.1);
    const Vec3 back = angles_of_rotation(rotation_of_angles(angles, order), order);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(back[axis], angles[axis], 1e-12) << order_name(order);
  }
}

TEST(JointAngles, DoNotJumpOverWholeTurns) {
  std::vector<Quat> rotations;
  for (int i = 0; i < 200; ++i) rotations.push_back(axis_rotation(2, i * 0.1));
  const JointAngles angles = joint_angles(rotations);
  EXPECT_EQ(angles.order, equation_6_order);
  EXPECT_NEAR(angles.degrees.back().z, 199 * 0.1 * radians_to_degrees, 1e-6);
}

TEST(JointAngles, TakeAnotherOrderNearGimbalLock) {
  std::vector<Quat> rotations;
  for (int i = 0; i <= 60; ++i)
    rotations.push_back(axis_rotation(0, 0.2 * std::sin(i * 0.3)) * axis_rotation(1, i * 0.03) *
                        axis_rotation(2, 0.3 * std::cos(i * 0.2)));
  const JointAngles angles = joint_angles(rotations);
  EXPECT_NE(angles.order, equation_6_order);
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const Quat again = rotation_of_angles(angles.degrees[i] * degrees_to_radians, angles.order);
    EXPECT_NEAR(std::abs(glm::dot(again, rotations[i])), 1.0, 1e-12);
    if (i > 0) {
      EXPECT_LT(glm::length(angles.degrees[i] - angles.degrees[i - 1]), 20.0);
    }
  }
}

TEST(JointAngles, NameTheirOrders) {
  EulerOrder order{};
  EXPECT_EQ(order_name({2, 0, 1}), "ZXY");
  EXPECT_TRUE(parse_order("YZX", order));
  EXPECT_EQ(order, (EulerOrder{1, 2, 0}));
  EXPECT_FALSE(parse_order("XXY", order));
}

}  // namespace
}  // namespace sinew
