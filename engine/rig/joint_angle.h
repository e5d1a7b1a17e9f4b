#pragma once
/// The angle of a bent joint, as engine/definitions.md 6 defines it for the joint that drives a muscle.

#include <optional>
#include <span>

#include "engine/core/math.h"
#include "engine/model/model.h"
#include "engine/model/muscle.h"
#include "engine/rig/humanoid.h"

namespace sinew {

/// The three joints between which an angle is measured.
struct JointAngle {
  int before = -1, at = -1, after = -1;  ///< nodes

  /// Degrees between the directions at -> before and at -> after, from posed global transforms; 180 when straight.
  double degrees(std::span<const Mat4> global) const;
};

/// The joint after a node: the next on the humanoid chain that the model has, else its first child, else -1.
int joint_after(const Model& model, const Humanoid& humanoid, int node);

/// The angle at `driver`: from `before` where it is given, else its humanoid parent, else its parent node; to `tip`
/// where it is given, else joint_after(). Nothing where either neighbour is missing.
std::optional<JointAngle> driver_angle(const Model& model, const Humanoid& humanoid, int driver, int tip = -1,
                                       int before = -1);

/// delta of engine/definitions.md 6: 0 at the rest angle, 1 at the reference angle, linear beyond it, never negative; 0
/// below 1e-9.
double muscle_activation(double angle, double rest_angle, double reference_angle);
/// The same by the muscle's own angles; 0 where it is switched off.
double muscle_activation(const Muscle& muscle, double angle);

}  // namespace sinew
