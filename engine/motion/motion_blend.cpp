#include "engine/motion/motion_blend.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

/// The turn about `up` that comes nearest to taking one root's rotation to another's: the twist of what lies between.
Quat heading_turn(const Quat& from, const Quat& to, const Vec3& up) {
  const Quat between = to * glm::conjugate(from);
  const Vec3 along = up * glm::dot(Vec3(between.x, between.y, between.z), up);
  const Quat twist(between.w, along.x, along.y, along.z);
  // Half a turn about a level axis heads nowhere.
  return glm::length(twist) < 1e-6 ? Quat(1, 0, 0, 0) : glm::normalize(twist);
}

}  // namespace

MotionFrame blended(const MotionFrame& a, const MotionFrame& b, double weight) {
  MotionFrame frame{glm::mix(a.root, b.root, weight), {}, {}};
  for (std::size_t j = 0; j < a.rotations.size(); ++j)
    frame.rotations.push_back(glm::normalize(glm::slerp(a.rotations[j], b.rotations[j], weight)));
  return frame;
}

MotionFrame motion_frame_at(const Motion& motion, double seconds) {
  const auto last = static_cast<double>(motion.frames.size() - 1);
  const double place = std::clamp(seconds / motion.frame_time, 0.0, last);
  const double whole = std::floor(place);
  const auto i = static_cast<std::size_t>(whole);
  // Whole frames but for rounding are taken as they are.
  if (place - whole < 1e-9 || i + 1 == motion.frames.size()) return motion.frames[i];
  return blended(motion.frames[i], motion.frames[i + 1], place - whole);
}

Motion joined(const Motion& first, const Motion& second, double blend, const Vec3& up) {
  const double start = first.duration() - blend;
  const MotionFrame& begin = second.frames.front();
  const MotionFrame meeting = motion_frame_at(first, start);
  const Quat turn = heading_turn(begin.rotations.front(), meeting.rotations.front(), up);
  Vec3 shift = meeting.root - begin.root;
  shift -= up * glm::dot(shift, up);
  const double duration = start + second.duration();
  Motion result{first.name, first.skeleton, first.frame_time, {}, {}};
  const auto frames = static_cast<std::size_t>(std::llround(duration / first.frame_time)) + 1;
  for (std::size_t i = 0; i < frames; ++i) {
    const double t = static_cast<double>(i) * first.frame_time;
    MotionFrame later = motion_frame_at(second, t - start);
    later.root = begin.root + shift + turn * (later.root - begin.root);
    later.rotations.front() = turn * later.rotations.front();
    const double weight = blend > 0.0 ? smoothstep01((t - start) / blend) : (t > start ? 1.0 : 0.0);
    result.frames.push_back(weight >= 1.0   ? later
                            : weight <= 0.0 ? motion_frame_at(first, t)
                                            : blended(motion_frame_at(first, t), later, weight));
  }
  return result;
}

Motion looped(const Motion& motion, int count, double blend, const Vec3& up) {
  Motion result = motion;
  for (int i = 1; i < count; ++i) result = joined(result, motion, blend, up);
  return result;
}

Motion cross_faded(const Motion& first, const Motion& second, double from, double to) {
  Motion result{first.name, first.skeleton, first.frame_time, {}, {}};
  const double duration = std::max(to, second.duration());
  const auto frames = static_cast<std::size_t>(std::llround(duration / first.frame_time)) + 1;
  for (std::size_t i = 0; i < frames; ++i) {
    const double t = static_cast<double>(i) * first.frame_time;
    result.frames.push_back(blended(motion_frame_at(first, t), motion_frame_at(second, t),
                                    smoothstep01((t - from) / std::max(to - from, 1e-9))));
  }
  return result;
}

Motion layered(const Motion& first, const Motion& second, const std::vector<int>& roots) {
  std::vector<bool> taken(first.skeleton.joints.size(), false);
  for (std::size_t j = 0; j < taken.size(); ++j) {
    const int parent = first.skeleton.joints[j].parent;
    taken[j] =
        std::find(roots.begin(), roots.end(), static_cast<int>(j)) != roots.end() || (parent >= 0 && taken[parent]);
  }
  Motion result = first;
  for (std::size_t i = 0; i < result.frames.size(); ++i) {
    const MotionFrame other = motion_frame_at(second, static_cast<double>(i) * first.frame_time);
    for (std::size_t j = 0; j < taken.size(); ++j)
      if (taken[j]) result.frames[i].rotations[j] = other.rotations[j];
  }
  return result;
}

}  // namespace sinew
