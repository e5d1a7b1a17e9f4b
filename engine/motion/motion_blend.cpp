#include "engine/motion/motion_blend.h"

#include <algorithm>
#include <cmath>

namespace sinew {

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
  Vec3 shift = motion_frame_at(first, start).root - second.frames.front().root;
  shift -= up * glm::dot(shift, up);
  const double duration = start + second.duration();
  Motion result{first.name, first.skeleton, first.frame_time, {}, {}};
  const auto frames = static_cast<std::size_t>(std::llround(duration / first.frame_time)) + 1;
  for (std::size_t i = 0; i < frames; ++i) {
    const double t = static_cast<double>(i) * first.frame_time;
    MotionFrame later = motion_frame_at(second, t - start);
    later.root += shift;
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
