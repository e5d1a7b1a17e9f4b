#pragma once
/// A motion as curves: what is stored, edited and played in place of its samples.

#include <array>
#include <vector>

#include "engine/model/motion.h"
#include "engine/motion/joint_angles.h"
#include "engine/motion/piecewise_polynomial.h"

namespace sinew {

using AxisCurves = std::array<PiecewisePolynomial, 3>;  ///< of x, y and z

struct JointCurves {
  EulerOrder order = equation_6_order;
  AxisCurves angles;  ///< alpha, beta, gamma, degrees: T of the joint, in its own frame, on top of its rest rotation
};

struct CurveClip {
  std::vector<JointCurves> joints;  ///< [joints of the skeleton]
  AxisCurves root;                  ///< the root's place, the skeleton's lengths
  double frame_time = 1.0 / 30.0;   ///< of the samples it stands for

  double begin() const { return root[0].begin(); }
  double end() const { return root[0].end(); }
  double duration() const { return end() - begin(); }
  std::size_t frames() const;  ///< samples from begin to end, both included
  std::size_t stored_numbers() const;
};

/// The skeleton at a time. `frame.rotations` is made as long as it must be.
void sample_curves(const CurveClip& clip, const MotionSkeleton& skeleton, double seconds, MotionFrame& frame);

/// What a pose costs: microseconds, the median over the clip, to sample all curves, turn them into the skeleton's
/// global transforms and those into a skin's palette, [joints], on one core.
double pose_microseconds(const CurveClip& clip, const MotionSkeleton& skeleton);

/// All of the clip's frames.
Motion sampled_motion(const CurveClip& clip, const MotionSkeleton& skeleton, const std::string& name);

/// What a motion's curves are fitted to.
struct MotionSamples {
  std::vector<double> times;                ///< [frames] seconds, from 0
  std::vector<JointAngles> joints;          ///< [joints]
  std::array<std::vector<double>, 3> root;  ///< [frames] of x, y and z
};

MotionSamples motion_samples(const Motion& motion);

/// One joint's turns from its rest rotation, [frames].
std::vector<Quat> joint_turns(const Motion& motion, std::size_t joint);

/// The distance of frames on a skeleton: how far the joints, bones' ends included, of `b` are from those of `a` at the
/// worst, the skeleton's lengths.
double largest_joint_distance(const MotionSkeleton& skeleton, const MotionFrame& a, const MotionFrame& b);

/// Every joint as it rests.
MotionFrame rest_frame(const MotionSkeleton& skeleton);

/// From the lowest to the highest joint at rest, or across where that is more; the skeleton's lengths, above 0.
double skeleton_size(const MotionSkeleton& skeleton);

}  // namespace sinew
