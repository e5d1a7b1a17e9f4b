#include "engine/core/euler.h"

#include <gtest/gtest.h>

#include <random>

namespace sinew::test {
namespace {

constexpr EulerOrder orders[] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

TEST(Euler, AnglesComeBackInEveryOrder) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> outer(-3.1, 3.1), inner(-1.55, 1.55);
  for (const EulerOrder& order : orders)
    for (int i = 0; i < 200; ++i) {
      const Vec3 angles(outer(random), inner(random), outer(random));
      const Vec3 back = to_euler(from_euler(angles, order), order);
      // The middle angle comes to 0.02 of gimbal lock: there 1e-16 in the matrix is 1e-12 in the angle.
      for (int a = 0; a < 3; ++a) EXPECT_NEAR(back[a], angles[a], 1e-9) << order[0] << order[1] << order[2];
    }
}

TEST(Euler, GimbalLockGivesTheSameRotation) {
  for (const EulerOrder& order : orders)
    for (const double middle : {90.0, -90.0}) {
      const Quat q = from_euler(Vec3(30, middle, 70) * degrees_to_radians, order);
      const Quat back = from_euler(to_euler(q, order), order);
      // An angle whose sine is 1 is known to the root of the rounding.
      EXPECT_NEAR(std::abs(glm::dot(q, back)), 1.0, 1e-12);
    }
}

TEST(Euler, TurnsGoFromRightToLeft) {
  // Rz Ry Rx of a vector turns it about x first: (0, 1, 0) goes to z, stays there about z.
  const Quat q = from_euler(Vec3(90, 0, 90) * degrees_to_radians, {2, 1, 0});
  EXPECT_LT(glm::length(q * Vec3(0, 1, 0) - Vec3(0, 0, 1)), 1e-15);
}

}  // namespace
}  // namespace sinew::test
