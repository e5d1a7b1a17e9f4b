#pragma once
/// What fitting and playing motions cost on one core, on a motion made up for it.

#include <cstddef>

#include "engine/model/motion.h"

namespace sinew {

struct MotionBench {
  std::size_t fit_frames = 0, fit_joints = 0, pose_joints = 0;
  double fit_ms = 0.0;   ///< all curves within half a degree, on one core
  double pose_us = 0.0;  ///< median: all curves sampled, the joints' global transforms, and the palette
};

/// A chain of joints whose every angle swings, with jitter of a tenth of a degree, 120 frames a second.
Motion made_up_motion(std::size_t joints, std::size_t frames);

/// Fits 2,752 frames of 31 joints; plays 68 joints.
MotionBench run_motion_bench();

}  // namespace sinew
