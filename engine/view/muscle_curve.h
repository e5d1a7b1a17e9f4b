#pragma once
/// A muscle's activation over its driver's angle, drawn on a panel. ImGui's calls inside.

#include "engine/view/muscle_edit.h"

namespace sinew {

struct MuscleAngleDrag {
  MuscleAngle which;
  double degrees;
};
/// What the pointer did to the curve.
struct MuscleCurveUse {
  std::optional<MuscleAngleDrag> drag;
  bool ended = false;  ///< a drag was let go
};

/// The swelling's height over the joint's angle, straight at the left, and where it stands now: `degrees`. `strength`:
/// of all muscles. Its rest and reference angles are marks that can be dragged.
MuscleCurveUse draw_muscle_curve(const Muscle& muscle, double strength, double degrees);

}  // namespace sinew
