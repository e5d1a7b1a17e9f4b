#pragma once
/// A joint's rotation as the three angles alpha, beta, gamma about x, y, z that curves are fitted to: Li et al. 2010,
/// equation 6; engine/definitions.md 14.

#include <span>
#include <string>
#include <vector>

#include "engine/core/euler.h"

namespace sinew {

/// Equation 6 is T = A(gamma) B(beta) C(alpha) for row vectors in DirectX's left-handed frame: v T turns about z, then
/// y, then x. As columns in our right-handed frame (z to -z) that is Rx(-alpha) Ry(-beta) Rz(gamma).
constexpr EulerOrder equation_6_order{0, 1, 2};

/// The rotation of (alpha, beta, gamma) radians: the product, in `order`, of Rx(-alpha), Ry(-beta), Rz(gamma).
Quat rotation_of_angles(const Vec3& angles, const EulerOrder& order = equation_6_order);

/// The angles whose rotation_of_angles() it is, the middle one within -pi/2..pi/2.
Vec3 angles_of_rotation(const Quat& rotation, const EulerOrder& order = equation_6_order);

/// A joint's angles over time.
struct JointAngles {
  EulerOrder order = equation_6_order;
  std::vector<Vec3> degrees;  ///< [frames] alpha, beta, gamma; no jump of a whole turn between frames
};

/// Equation 6's order, unless the middle angle comes within 15 degrees of gimbal lock (90 degrees): then the order of
/// the six in which the angles travel least. Of the equivalent angles each frame has those nearest to the frame before.
JointAngles joint_angles(std::span<const Quat> rotations);

/// The same in an order that is given: [frames] alpha, beta, gamma in degrees.
std::vector<Vec3> angles_in_order(std::span<const Quat> rotations, const EulerOrder& order);

/// "XYZ" and so on: the product's factors from left to right, as BVH's channels have it.
std::string order_name(const EulerOrder& order);
/// The reverse; false where it is no such name.
bool parse_order(const std::string& name, EulerOrder& order);

}  // namespace sinew
