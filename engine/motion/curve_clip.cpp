#include "engine/motion/curve_clip.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace sinew {
namespace {

struct Placed {
  Vec3 place;
  Quat rotation;
};

/// Where the joints stand, then where bones end that no joint ends.
std::vector<Vec3> places(const MotionSkeleton& skeleton, const MotionFrame& frame) {
  std::vector<Placed> joints;
  std::vector<Vec3> all;
  for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
    const MotionJoint& joint = skeleton.joints[j];
    if (joint.parent < 0) {
      joints.push_back({frame.root, frame.rotations[j]});
    } else {
      const Placed& parent = joints[joint.parent];
      joints.push_back({parent.place + parent.rotation * joint.offset, parent.rotation * frame.rotations[j]});
    }
    all.push_back(joints.back().place);
  }
  for (std::size_t j = 0; j < skeleton.joints.size(); ++j)
    if (const auto& end = skeleton.joints[j].end) all.push_back(joints[j].place + joints[j].rotation * *end);
  return all;
}

}  // namespace

std::size_t CurveClip::frames() const { return static_cast<std::size_t>(std::llround(duration() / frame_time)) + 1; }

std::size_t CurveClip::stored_numbers() const {
  std::size_t numbers = 0;
  for (const JointCurves& joint : joints)
    for (const PiecewisePolynomial& curve : joint.angles) numbers += curve.stored_numbers();
  for (const PiecewisePolynomial& curve : root) numbers += curve.stored_numbers();
  return numbers;
}

void sample_curves(const CurveClip& clip, const MotionSkeleton& skeleton, double seconds, MotionFrame& frame) {
  for (int axis = 0; axis < 3; ++axis) frame.root[axis] = clip.root[axis].value(seconds);
  frame.rotations.resize(clip.joints.size());
  for (std::size_t j = 0; j < clip.joints.size(); ++j) {
    const JointCurves& joint = clip.joints[j];
    Vec3 angles;
    for (int axis = 0; axis < 3; ++axis) angles[axis] = joint.angles[axis].value(seconds) * degrees_to_radians;
    frame.rotations[j] = skeleton.joints[j].rest_rotation * rotation_of_angles(angles, joint.order);
  }
}

double pose_microseconds(const CurveClip& clip, const MotionSkeleton& skeleton) {
  constexpr int poses = 501;
  std::vector<Mat4> global(skeleton.joints.size()), inverse_bind;
  std::vector<Mat34> palette(global.size());
  std::vector<double> times;
  MotionFrame frame = rest_frame(skeleton);
  const auto set_globals = [&] {
    for (std::size_t j = 0; j < global.size(); ++j) {
      const MotionJoint& joint = skeleton.joints[j];
      Mat4 local = glm::mat4_cast(frame.rotations[j]);
      local[3] = Vec4(joint.parent < 0 ? frame.root : joint.offset, 1.0);
      global[j] = joint.parent < 0 ? local : global[joint.parent] * local;
    }
  };
  set_globals();
  for (const Mat4& rest : global) inverse_bind.push_back(glm::inverse(rest));
  for (int i = 0; i < poses; ++i) {
    const auto begun = std::chrono::steady_clock::now();
    sample_curves(clip, skeleton, clip.begin() + clip.duration() * i / (poses - 1.0), frame);
    set_globals();
    for (std::size_t j = 0; j < global.size(); ++j) palette[j] = Mat34::from(global[j] * inverse_bind[j]);
    const std::chrono::duration<double, std::micro> taken = std::chrono::steady_clock::now() - begun;
    times.push_back(taken.count());
  }
  std::nth_element(times.begin(), times.begin() + poses / 2, times.end());
  return times[poses / 2];
}

Motion sampled_motion(const CurveClip& clip, const MotionSkeleton& skeleton, const std::string& name) {
  Motion motion{name, skeleton, clip.frame_time, std::vector<MotionFrame>(clip.frames()), {}};
  for (std::size_t i = 0; i < motion.frames.size(); ++i)
    sample_curves(clip, skeleton, clip.begin() + static_cast<double>(i) * clip.frame_time, motion.frames[i]);
  return motion;
}

std::vector<Quat> joint_turns(const Motion& motion, std::size_t joint) {
  std::vector<Quat> turns;
  const Quat from_rest = glm::conjugate(motion.skeleton.joints[joint].rest_rotation);
  for (const MotionFrame& frame : motion.frames) turns.push_back(from_rest * frame.rotations[joint]);
  return turns;
}

MotionSamples motion_samples(const Motion& motion) {
  MotionSamples samples;
  for (std::size_t i = 0; i < motion.frames.size(); ++i) {
    samples.times.push_back(static_cast<double>(i) * motion.frame_time);
    for (int axis = 0; axis < 3; ++axis) samples.root[axis].push_back(motion.frames[i].root[axis]);
  }
  for (std::size_t j = 0; j < motion.skeleton.joints.size(); ++j)
    samples.joints.push_back(joint_angles(joint_turns(motion, j)));
  return samples;
}

double largest_joint_distance(const MotionSkeleton& skeleton, const MotionFrame& a, const MotionFrame& b) {
  const std::vector<Vec3> first = places(skeleton, a), second = places(skeleton, b);
  double largest = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) largest = std::max(largest, glm::length(first[i] - second[i]));
  return largest;
}

MotionFrame rest_frame(const MotionSkeleton& skeleton) {
  MotionFrame rest;
  rest.root = skeleton.joints.front().offset;
  for (const MotionJoint& joint : skeleton.joints) rest.rotations.push_back(joint.rest_rotation);
  return rest;
}

double skeleton_size(const MotionSkeleton& skeleton) {
  Bounds bounds;
  for (const Vec3& place : places(skeleton, rest_frame(skeleton))) bounds.add(place);
  const Vec3 size = bounds.high - bounds.low;
  return std::max({size.x, size.y, size.z, 1e-9});
}

}  // namespace sinew
