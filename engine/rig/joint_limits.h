#pragma once
/// How far the joints of a humanoid turn in people: ranges of motion of the American Academy of Orthopaedic Surgeons
/// (Joint Motion, 1965), rounded, and a little wider where a rest pose is not exactly the anatomical one.

#include <optional>
#include <span>

#include "engine/core/math.h"
#include "engine/model/model.h"
#include "engine/rig/humanoid.h"

namespace sinew {

struct DegreeRange {
  double low = -180.0, high = 180.0;
  bool operator==(const DegreeRange&) const = default;
};

/// What a joint may be turned by from its rest pose. Axes are unit vectors of the model at rest, at right angles.
struct JointLimits {
  Vec3 along{1, 0, 0};  ///< the bone's direction: twist turns about it
  Vec3 bend{0, 1, 0};   ///< of the joint's chief movement, positive as elbow, knee, hip, wrist and finger close
  Vec3 side{0, 0, 1};
  DegreeRange twist_degrees, bend_degrees, side_degrees;
};

/// Nothing where the node is no joint of the humanoid, or one that goes where it likes, as hips, eyes and thumbs.
/// `rest_global`: [nodes] global transforms of the rest pose.
std::optional<JointLimits> joint_limits(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global,
                                        int node);

/// The nearest turn within the limits: twist, bend and side are each held. `turn`: of the model's axes from rest.
Quat hold_turn(const JointLimits& limits, const Quat& turn);
bool is_within(const JointLimits& limits, const Quat& turn);

/// The three numbers of a joint key (degrees about the model's x, y, z, x first) that make a turn; of all that do the
/// nearest to `near`.
Vec3 key_degrees(const Quat& turn, const Vec3& near);

/// Between which values one of a key's numbers keeps the turn within the limits while the others stay; to a degree, and
/// all of -180..180 where they are left already.
DegreeRange number_range(const JointLimits& limits, const Vec3& degrees, int axis);

}  // namespace sinew
