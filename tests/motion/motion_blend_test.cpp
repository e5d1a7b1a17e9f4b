#include "engine/motion/motion_blend.h"

#include <gtest/gtest.h>

#include "tests/motion/made_up_motion.h"

namespace sinew {
namespace {

const Vec3 up(0, 1, 0);

/// The whole body turned about the upright, seen from above counter-clockwise, and moved.
Motion carried(Motion motion, double degrees, const Vec3& move) {
  const Quat turn = axis_rotation(1, degrees * degrees_to_radians);
  for (MotionFrame& frame : motion.frames) {
    frame.root = turn * frame.root + move;
    frame.rotations.front() = turn * frame.rotations.front();
  }
  return motion;
}

double largest_difference(const Motion& a, const Motion& b) {
  double largest = a.frames.size() == b.frames.size() ? 0.0 : INFINITY;
  for (std::size_t i = 0; i < std::min(a.frames.size(), b.frames.size()); ++i) {
    largest = std::max(largest, glm::length(a.frames[i].root - b.frames[i].root));
    for (std::size_t j = 0; j < a.frames[i].rotations.size(); ++j)
      largest = std::max(largest, 1.0 - std::abs(glm::dot(a.frames[i].rotations[j], b.frames[i].rotations[j])));
  }
  return largest;
}

TEST(MotionBlend, JoinsWhereverTheSecondHeads) {
  const Motion first = test::made_up_motion("first"), second = test::made_up_motion("second", 40, 0.5);
  const Motion straight = joined(first, second, 0.4, up);
  for (const double degrees : {30.0, 90.0, 180.0, -135.0})
    EXPECT_LT(largest_difference(joined(first, carried(second, degrees, {3, 0, -2}), 0.4, up), straight), 1e-12)
        << degrees;
  EXPECT_LT(
      largest_difference(joined(carried(first, 70.0, {1, 0, 1}), second, 0.4, up), carried(straight, 70.0, {1, 0, 1})),
      1e-12);
}

TEST(MotionBlend, AWalkInAnArcGoesOnRoundTheCircle) {
  // A sixth of a circle of radius 1 about the origin, heading along it.
  Motion arc = test::made_up_motion("arc", 31, 0.0);
  for (std::size_t i = 0; i < arc.frames.size(); ++i) {
    const double angle = static_cast<double>(i) * 2.0 * degrees_to_radians;
    arc.frames[i].root = {std::cos(angle), 1.0, -std::sin(angle)};
    arc.frames[i].rotations.front() = axis_rotation(1, angle);
  }
  const Motion circle = looped(arc, 6, 0.0, up);
  for (const MotionFrame& frame : circle.frames) EXPECT_NEAR(std::hypot(frame.root.x, frame.root.z), 1.0, 1e-9);
  EXPECT_NEAR(glm::length(circle.frames.back().root - circle.frames.front().root), 0.0, 1e-9);
}

TEST(MotionBlend, KeepsALeanAndTheHeight) {
  const Motion first = test::made_up_motion("first");
  Motion second = test::made_up_motion("second", 40, 0.5);
  for (MotionFrame& frame : second.frames) {
    frame.root.y = 0.4;
    frame.rotations.front() = axis_rotation(1, 1.1) * axis_rotation(0, 0.6);
  }
  const Motion both = joined(first, second, 0.2, up);
  const Vec3 own_up = both.frames.back().rotations.front() * up;
  EXPECT_NEAR(own_up.y, std::cos(0.6), 1e-12);
  EXPECT_NEAR(both.frames.back().root.y, 0.4, 1e-12);
}

}  // namespace
}  // namespace sinew
