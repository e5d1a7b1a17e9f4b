#include <cmath>

#include "engine/motion/library.h"

namespace sinew {

double find_apex(const Motion& motion) {
  std::size_t apex = 0;
  double most = 0.0;
  for (std::size_t i = 0; i < motion.frames.size(); ++i) {
    double squares = 0.0;
    for (std::size_t j = 0; j < motion.skeleton.joints.size(); ++j) {
      const Quat turn = glm::conjugate(motion.frames.front().rotations[j]) * motion.frames[i].rotations[j];
      const double angle = 2.0 * std::atan2(glm::length(Vec3(turn.x, turn.y, turn.z)), std::abs(turn.w));
      squares += angle * angle;
    }
    if (squares > most) {
      most = squares;
      apex = i;
    }
  }
  return static_cast<double>(apex) * motion.frame_time;
}

double apex_of(const StoredClip& clip) { return clip.entry.apex.value_or(find_apex(clip.motion)); }

}  // namespace sinew
