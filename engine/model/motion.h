#pragma once
/// A motion: a skeleton and how its joints turn over time, as a capture file holds it, whatever the file's format.
/// Plain data; lengths in the file's own units, right-handed, whichever axis the file calls up.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

/// One number a frame of one joint, as files order them.
enum class MotionChannel : unsigned char { x_position, y_position, z_position, x_rotation, y_rotation, z_rotation };

/// A joint of a motion's skeleton.
struct MotionJoint {
  std::string name;
  int parent = -1;                         ///< index of a joint before this one; -1: the root
  Vec3 offset{0.0};                        ///< rest place in the parent's frame; of the root: in the world
  Quat rest_rotation{1.0, 0.0, 0.0, 0.0};  ///< rest rotation in the parent's frame; identity in BVH
  std::vector<MotionChannel> channels;     ///< as the file orders them; empty: not animated, or no order is known
  std::optional<Vec3> end;  ///< where the joint's bone ends, in its own frame, where no joint stands there
};

/// Joints, parents before their children, the root first.
struct MotionSkeleton {
  std::vector<MotionJoint> joints;
  std::optional<double> metres_per_unit;  ///< as the file states it; nothing: it does not
  std::map<std::string, int> humanoid;    ///< VRM 1.0 bone -> joint, from the file's own map; else empty
};

/// The skeleton at one moment.
struct MotionFrame {
  Vec3 root{0.0};               ///< the root's place in the world
  std::vector<Quat> rotations;  ///< [joints] in the parent's frame, unit length, rest rotation included
  std::vector<Vec3> offsets;    ///< [joints] in the parent's frame; empty: all but the root stay at their rest offsets
};

struct Motion {
  std::string name;  ///< of the clip: the file's stem, or the animation's name
  MotionSkeleton skeleton;
  double frame_time = 1.0 / 30.0;     ///< seconds from a frame to the next, > 0
  std::vector<MotionFrame> frames;    ///< at least one
  std::vector<std::string> problems;  ///< what was repaired or left out on reading, for people

  /// Seconds from the first frame to the last.
  double duration() const { return frames.empty() ? 0.0 : frame_time * static_cast<double>(frames.size() - 1); }
};

/// The axes that a joint's rotation channels turn about, 0 to 2 for x to z, in the file's order. As columns the
/// rotation is the product of single turns in that order: Zrotation Yrotation Xrotation is Rz Ry Rx.
inline std::vector<int> rotation_order(const MotionJoint& joint) {
  std::vector<int> axes;
  for (const MotionChannel channel : joint.channels)
    if (channel >= MotionChannel::x_rotation)
      axes.push_back(static_cast<int>(channel) - static_cast<int>(MotionChannel::x_rotation));
  return axes;
}

}  // namespace sinew
