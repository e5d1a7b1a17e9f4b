#include "engine/motion/apex.h"

#include <algorithm>
#include <cmath>

namespace sinew {

std::vector<double> deviations(const Motion& motion) {
  std::vector<double> deviations;
  for (const MotionFrame& frame : motion.frames) {
    double squares = 0.0;
    for (std::size_t j = 0; j < motion.skeleton.joints.size(); ++j) {
      const Quat turn = glm::conjugate(motion.frames.front().rotations[j]) * frame.rotations[j];
      const double angle = 2.0 * std::atan2(glm::length(Vec3(turn.x, turn.y, turn.z)), std::abs(turn.w));
      squares += angle * angle;
    }
    deviations.push_back(std::sqrt(squares / static_cast<double>(motion.skeleton.joints.size())));
  }
  return deviations;
}

double find_apex(const Motion& motion) {
  const std::vector<double> all = deviations(motion);
  return static_cast<double>(std::max_element(all.begin(), all.end()) - all.begin()) * motion.frame_time;
}

double apex_of(const StoredClip& clip) {
  if (clip.entry.apex) return *clip.entry.apex;
  if (!clip.curves) return find_apex(clip.motion);
  return find_apex(sampled_motion(*clip.curves, clip.motion.skeleton, clip.entry.name));
}

}  // namespace sinew
