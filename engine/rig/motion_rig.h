#pragma once
/// The body in a motion: which joint is which humanoid bone, which way is up, how large it is.

#include <vector>

#include "engine/model/model.h"
#include "engine/model/motion.h"
#include "engine/rig/humanoid.h"
#include "engine/rig/humanoid_shape.h"

namespace sinew {

/// The skeleton as a model without meshes: node j is joint j, then a nameless node for each bone's free end.
Model skeleton_model(const MotionSkeleton& skeleton);

/// Global rotations and places of all joints at a frame, in the file's units and axes.
struct MotionPose {
  std::vector<Quat> rotations;  ///< [joints]
  std::vector<Vec3> places;     ///< [joints]
};
MotionPose motion_pose(const Motion& motion, std::size_t frame);
/// The same of the rest pose.
MotionPose motion_rest(const MotionSkeleton& skeleton);

/// Joints of the trunk, from below: those between hips and neck, or between neck and head, the upper end included,
/// with nodes that are no humanoid bones. `lower` itself is not among them.
std::vector<int> joints_between(const Model& model, const Humanoid& humanoid, HumanoidBone lower, HumanoidBone upper);

/// The body's axes in a rest pose, at right angles to each other. Joints stand a little before or behind each other in
/// every body, which says nothing of how it stands: up within 25 degrees of an axis of the file is that axis, left
/// within 15 degrees likewise.
BodyAxes standing_axes(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global);

/// How high the hips are over the ankles when the legs are straight: hips to thighs along up, thigh and shin of the
/// longer leg. 0 where the joints for that are absent.
double hip_height(const Humanoid& humanoid, std::span<const Mat4> rest_global, const Vec3& up);

struct MotionRig {
  Model model;                    ///< skeleton_model
  std::vector<Mat4> rest_global;  ///< [nodes]
  Humanoid humanoid;
  BodyAxes rest_axes;              ///< of the rest pose
  Vec3 up{0, 1, 0};                ///< of the world that the motion happens in; an axis of the file
  double height = 0.0;             ///< hip_height, file units
  double metres_per_unit = 1.0;    ///< as the file states it where that makes a body; else from the hip height
  std::vector<std::string> notes;  ///< the humanoid's, and what was found of axes and scale
};

MotionRig motion_rig(const Motion& motion);

}  // namespace sinew
