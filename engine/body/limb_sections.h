#pragma once
/// The surface of the arm from the shoulder to the wrist: a skin drawn over muscles and bones along a straight axis.

#include "engine/core/math.h"

namespace sinew {

/// The arm's surface at distance `x` along its axis, in direction `angle`, for an upper arm of 0.30 m and a lower arm
/// of 0.26 m. The shoulder joint is at x = 0, the elbow at 0.30, the wrist at 0.56. `angle` in radians is the parameter
/// of an ellipse: 0 is +Y (thumb side), a quarter turn +Z (flexor side). Returns the point's y and z, metres from the
/// axis.
Vec2 limb_section(double x, double angle);

/// The `angle` at which the section through `x` has the direction of (y, z).
double limb_section_angle(double x, const Vec2& yz);

}  // namespace sinew
