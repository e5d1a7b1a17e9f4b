#pragma once
/// Hands and feet that are put somewhere: two bones bent at the joint between them, solved in closed form.

#include <optional>
#include <span>

#include "engine/rig/joint_limits.h"

namespace sinew {

/// An arm or a leg.
struct Limb {
  HumanoidBone end_bone;
  int upper = -1, lower = -1, end = -1;  ///< nodes: shoulder, elbow, wrist; or hip, knee, ankle
  JointLimits upper_limits, lower_limits;
};

/// `end`: a hand or a foot. Nothing where the model lacks one of the three joints. `rest_global`: as in joint_limits().
std::optional<Limb> find_limb(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global,
                              HumanoidBone end);

/// A joint as it stands: its turn from rest about the model's axes, and what carries these axes into the world.
struct TurnedJoint {
  Quat carried{1, 0, 0, 0};
  Quat turn{1, 0, 0, 0};
  Vec3 place{0.0};  ///< world
};

struct LimbTurns {
  Quat upper{1, 0, 0, 0}, lower{1, 0, 0, 0};
};

/// The turns that bring the end as near to `target` as limits let it. The lower joint bends about its own hinge, the
/// way elbows and knees do, and keeps its twist; the upper one goes the shortest way. A limb that cannot reach is
/// straight towards the target. An upper joint beyond its limits already is not held. World units.
LimbTurns reach(const Limb& limb, const TurnedJoint& upper, const TurnedJoint& lower, const Vec3& end,
                const Vec3& target);

}  // namespace sinew
