#pragma once
/// Motions made of two: on one skeleton, frame by frame.

#include <vector>

#include "engine/model/motion.h"

namespace sinew {

/// The frame at a time, between frames by spherical interpolation; held before the first and after the last.
MotionFrame motion_frame_at(const Motion& motion, double seconds);

/// Places by line, rotations by the shorter arc; weight 0: all of `a`.
MotionFrame blended(const MotionFrame& a, const MotionFrame& b, double weight);

/// `second` after `first`, the two overlapping by `blend` seconds in which the weight goes smoothly over. The second is
/// turned about `up` and moved level so that it begins where the first stands then, and heads as that does. Its frame
/// time is the first's.
Motion joined(const Motion& first, const Motion& second, double blend, const Vec3& up);

/// The same clip `count` times, joined to itself.
Motion looped(const Motion& motion, int count, double blend, const Vec3& up);

/// The first until `from`, the second from `to` on, both at their own times.
Motion cross_faded(const Motion& first, const Motion& second, double from, double to);

/// The joints of `roots`, and all below them, from the second motion; the rest, and the length, are the first's.
Motion layered(const Motion& first, const Motion& second, const std::vector<int>& roots);

/// Frames at other times: at time t of the new motion stands time `at(t)` of the old one.
template <class At>
Motion resampled(const Motion& motion, double duration, const At& at) {
  Motion result{motion.name, motion.skeleton, motion.frame_time, {}, {}};
  const auto frames = static_cast<std::size_t>(std::llround(duration / motion.frame_time)) + 1;
  for (std::size_t i = 0; i < frames; ++i)
    result.frames.push_back(motion_frame_at(motion, at(static_cast<double>(i) * motion.frame_time)));
  return result;
}

/// Left and right exchanged, by mirroring every joint's turn from its rest pose at the body's plane of symmetry. A
/// joint without a partner, by humanoid bone or by name, is its own.
Motion mirrored(const Motion& motion);

}  // namespace sinew
