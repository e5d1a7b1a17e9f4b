#pragma once
/// The turn of a limb about its own axis, shared out among the joints that a rig has for it.

#include <span>
#include <vector>

#include "engine/core/math.h"
#include "engine/model/model.h"
#include "engine/rig/humanoid.h"

namespace sinew {

/// A limb's segment with joints that only twist: they stand between its two joints, or hang from the first and carry
/// nothing.
struct TwistSegment {
  int bone = -1, next = -1;  ///< nodes; the segment's axis goes from the first to the second
  bool upper = false;        ///< upper arm or leg: the twist is the bone's own against its parent; else that of `next`
  std::vector<int> between;  ///< nodes from bone to next, that twist and hand the twist on
  struct Leaf {
    int node = -1;
    double at = 0.5;  ///< along the segment, 0 at the bone, 1 at the next
  };
  std::vector<Leaf> leaves;
};

/// The segments of arms and legs that have such joints. `rest_global`: [nodes].
std::vector<TwistSegment> twist_segments(const Model& model, const Humanoid& humanoid,
                                         std::span<const Mat4> rest_global);

/// The turn about `axis` (unit length) in a rotation, degrees -180..180, faded out where it is not defined or jumps:
/// near half a turn of its own or of the swing.
double twist_degrees(const Quat& rotation, const Vec3& axis);

/// Shares the twist out. `rotations`: [nodes] global rotations, right at bone and next; what changes are they and the
/// twist joints, in equal steps along the segment. Where the limb points stays as it is. `rest`: [nodes] global rest
/// rotations.
void share_twist(const Model& model, const TwistSegment& segment, std::span<const Quat> rest,
                 std::span<const Mat4> rest_global, std::span<Quat> rotations);

}  // namespace sinew
