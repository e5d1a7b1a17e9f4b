#pragma once
/// Rest limbs of one body turned onto those of another.

#include <optional>
#include <span>
#include <vector>

#include "engine/core/math.h"
#include "engine/model/model.h"
#include "engine/rig/humanoid.h"
#include "engine/rig/humanoid_shape.h"

namespace sinew {

/// A body at rest.
struct RestBody {
  const Model& model;
  const Humanoid& humanoid;
  std::span<const Mat4> global;  ///< [nodes]
  BodyAxes axes;                 ///< standing_axes()
};

/// The shortest turn that takes one direction to another; of opposite ones, half a turn about any axis across.
Quat turn_between(const Vec3& from, const Vec3& to);

/// How much each node of `body` is turned in the world so that it rests as `like` does, [nodes]: all by the turn
/// between the bodies' axes, then arms, hands, fingers and legs, from the trunk outwards, by the shortest turn onto the
/// directions in which `like` rests. Feet keep their soles as they stand to a leg that hangs straight, and take the
/// other's toes' heading. Limbs that either body lacks follow the joint above.
std::vector<Quat> rest_alignment(const RestBody& body, const RestBody& like, std::span<const int> order);

}  // namespace sinew
