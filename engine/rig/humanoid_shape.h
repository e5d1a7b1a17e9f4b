#pragma once
/// What the shape of a skeleton says about the humanoid bones, names left aside.

#include <optional>
#include <vector>

#include "engine/core/math.h"
#include "engine/rig/humanoid_bone.h"
#include "engine/rig/joint_tree.h"

namespace sinew {

/// No bone found yet.
BoneNodes no_bones();

/// Exchanges left and right of every bone from `first` on, in the order of HumanoidBone (arms and hands come last).
void swap_sides(BoneNodes& bones, HumanoidBone first = HumanoidBone::hips);

/// The body's own directions, unit length, each at right angles to the others; of a right-handed skeleton
/// front = cross(left, up).
struct BodyAxes {
  Vec3 up, left, front;
};

/// Measured from the joints: up from the hips to the neck (or head), left from the right to the left hips and
/// shoulders. Where the joints for that are absent: +Y, +X, +Z.
BodyAxes body_axes(const JointTree& tree, const BoneNodes& bones);

/// How far feet and knees say that the body faces `front` rather than the opposite, in world units: positive where toes
/// and kneecaps point that way. Near zero where the joints do not tell.
double facing_evidence(const JointTree& tree, const BoneNodes& bones, const Vec3& up, const Vec3& front);

/// Thigh and shin of the longer leg that is whole, 0 where none is.
double leg_length(const JointTree& tree, const BoneNodes& bones);

/// True where the arms are a second pair of legs: the trunk is nearly level over the legs and the hands reach the
/// ground. False where hips, a neck or head, or a joint of the limbs is missing.
bool stands_on_four_legs(const JointTree& tree, const BoneNodes& bones);

/// Gives the joints between hips and neck, from below, to spine, chest and upperChest.
void assign_spine(const JointTree& tree, const std::vector<int>& joints, BoneNodes& bones);

/// A skeleton read without names.
struct ShapeFinding {
  BoneNodes bones;
  bool four_legs = false;  ///< then it is no humanoid: `bones` calls its front legs arms
};

/// Hips with one pair of mirrored legs, a spine, a chest with one pair of mirrored arms and a head. Nothing where there
/// is no such place in the skeleton, more than one, or where left and right cannot be told.
std::optional<ShapeFinding> find_by_shape(const JointTree& tree);

}  // namespace sinew
