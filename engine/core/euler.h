#pragma once
/// Rotations as three turns about the axes x, y, z in any order.

#include <array>

#include "engine/core/math.h"

namespace sinew {

/// Three different axes, 0 to 2 for x to z: as columns the rotation is R(order[0]) R(order[1]) R(order[2]).
using EulerOrder = std::array<int, 3>;

/// The turn about the axis x, y or z (0 to 2) by `radians`.
Quat axis_rotation(int axis, double radians);

/// The product of the three turns; `radians` stand in the order of the turns.
Quat from_euler(const Vec3& radians, const EulerOrder& order);

/// The angles, in the order of the turns, whose from_euler() is `rotation`: the first and last within -pi..pi, the
/// middle one within -pi/2..pi/2. In gimbal lock, where the middle one is at its end, the last is 0.
Vec3 to_euler(const Quat& rotation, const EulerOrder& order);

}  // namespace sinew
