#include "engine/motion/motion_bench.h"

#include <cmath>
#include <random>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "engine/motion/motion_fit.h"

namespace sinew {

Motion made_up_motion(std::size_t joints, std::size_t frames) {
  Motion motion;
  motion.name = "made up";
  motion.frame_time = 1.0 / 120.0;
  std::mt19937 generator(1);
  const auto jitter = [&] {
    return (static_cast<double>(generator()) / 4294967295.0 - 0.5) * 0.2 * degrees_to_radians;
  };
  for (std::size_t j = 0; j < joints; ++j) {
    MotionJoint joint;
    joint.name = fmt::format("joint{}", j);
    joint.parent = static_cast<int>(j) - 1;
    joint.offset = {0.0, 0.1, 0.0};
    motion.skeleton.joints.push_back(joint);
  }
  for (std::size_t i = 0; i < frames; ++i) {
    MotionFrame& frame = motion.frames.emplace_back();
    const double t = static_cast<double>(i) * motion.frame_time;
    for (std::size_t j = 0; j < joints; ++j) {
      const auto phase = static_cast<double>(j);
      const Vec3 angles(0.3 * std::sin(4.0 * t + phase) + jitter(), 0.2 * std::cos(3.0 * t - phase) + jitter(),
                        0.3 * std::sin((2.0 + 0.1 * phase) * t) + jitter());
      frame.rotations.push_back(rotation_of_angles(angles));
    }
  }
  return motion;
}

MotionBench run_motion_bench() {
  CurveFitOptions options;
  options.tolerance = 0.5;
  MotionBench bench{2752, 31, 68};
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  bench.fit_ms = fit_motion(made_up_motion(bench.fit_joints, bench.fit_frames), options).ms;
  const Motion played = made_up_motion(bench.pose_joints, 480);
  bench.pose_us = pose_microseconds(fit_motion(played, options).clip, played.skeleton);
  return bench;
}

}  // namespace sinew
