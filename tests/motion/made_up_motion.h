#pragma once
/// A small body that moves: two arms and a head on a trunk.

#include <cmath>

#include "engine/core/euler.h"
#include "engine/model/motion.h"

namespace sinew::test {

inline Motion made_up_motion(const std::string& name, int frames = 60, double size = 1.0) {
  Motion motion;
  motion.name = name;
  const auto joint = [&](const char* called, int parent, const Vec3& offset) {
    MotionJoint made;
    made.name = called;
    made.parent = parent;
    made.offset = offset;
    motion.skeleton.joints.push_back(made);
  };
  joint("Hips", -1, {0, 1, 0});
  joint("Spine", 0, {0, 0.3, 0});
  joint("Head", 1, {0, 0.3, 0});
  joint("LeftArm", 1, {0.2, 0.2, 0});
  joint("RightArm", 1, {-0.2, 0.2, 0});
  motion.frame_time = 1.0 / 30.0;
  for (int i = 0; i < frames; ++i) {
    const double t = i * motion.frame_time;
    MotionFrame frame;
    frame.root = {0.1 * t, 1.0, 0.5 * t};
    frame.rotations = {Quat(1, 0, 0, 0), axis_rotation(1, 0.2 * size * std::sin(2 * t)),
                       axis_rotation(0, 0.3 * size * std::sin(3 * t)), axis_rotation(2, 0.9 * size * std::sin(2.5 * t)),
                       axis_rotation(0, 0.2 * size * std::cos(2 * t))};
    motion.frames.push_back(frame);
  }
  return motion;
}

}  // namespace sinew::test
