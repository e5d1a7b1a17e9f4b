#include "engine/motion/joint_angles.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

/// From the paper's left-handed frame to ours: turns about x and y change their sign.
const Vec3 handedness{-1.0, -1.0, 1.0};

constexpr double lock_margin = 15.0;  ///< degrees before 90

constexpr std::array<EulerOrder, 6> all_orders{{{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

/// The largest middle angle, radians.
double nearest_to_lock(std::span<const Quat> rotations, const EulerOrder& order) {
  double largest = 0.0;
  for (const Quat& rotation : rotations) largest = std::max(largest, std::abs(to_euler(rotation, order)[1]));
  return largest;
}

/// Whole turns added so that each angle is nearest to what it was.
Vec3 unwrapped(Vec3 angles, const Vec3& before) {
  constexpr double turn = 2.0 * std::numbers::pi;
  for (int axis = 0; axis < 3; ++axis) angles[axis] -= turn * std::round((angles[axis] - before[axis]) / turn);
  return angles;
}

/// The other angles of the same rotation: first and last half a turn on, the middle one mirrored at its quarter turn.
Vec3 equivalent(Vec3 angles, const EulerOrder& order) {
  angles[order[0]] += std::numbers::pi;
  angles[order[1]] = std::numbers::pi - angles[order[1]];
  angles[order[2]] += std::numbers::pi;
  return angles;
}

/// How far the angles go altogether: near gimbal lock two of them whirl.
double travelled(const std::vector<Vec3>& degrees) {
  double sum = 0.0;
  for (std::size_t i = 1; i < degrees.size(); ++i) sum += glm::length(degrees[i] - degrees[i - 1]);
  return sum;
}

}  // namespace

Quat rotation_of_angles(const Vec3& angles, const EulerOrder& order) {
  const Vec3 turns = angles * handedness;
  return from_euler({turns[order[0]], turns[order[1]], turns[order[2]]}, order);
}

Vec3 angles_of_rotation(const Quat& rotation, const EulerOrder& order) {
  const Vec3 turns = to_euler(rotation, order);
  Vec3 angles;
  for (int i = 0; i < 3; ++i) angles[order[i]] = turns[i];
  return angles * handedness;
}

JointAngles joint_angles(std::span<const Quat> rotations) {
  JointAngles angles;
  const double nearest = nearest_to_lock(rotations, angles.order);
  if (nearest > (90.0 - lock_margin) * degrees_to_radians) {
    double least = INFINITY;
    for (const EulerOrder& order : all_orders) {
      const double trial = travelled(angles_in_order(rotations, order));
      if (trial < least) {
        least = trial;
        angles.order = order;
      }
    }
  }
  angles.degrees = angles_in_order(rotations, angles.order);
  return angles;
}

std::vector<Vec3> angles_in_order(std::span<const Quat> rotations, const EulerOrder& order) {
  std::vector<Vec3> degrees;
  Vec3 before(0.0);
  for (const Quat& rotation : rotations) {
    const Vec3 principal = angles_of_rotation(rotation, order);
    const Vec3 a = unwrapped(principal, before), b = unwrapped(equivalent(principal, order), before);
    // The first frame has the plain angles.
    const bool other = !degrees.empty() && glm::length(b - before) < glm::length(a - before);
    before = degrees.empty() ? principal : other ? b : a;
    degrees.push_back(before * radians_to_degrees);
  }
  return degrees;
}

std::string order_name(const EulerOrder& order) {
  std::string name;
  for (const int axis : order) name += "XYZ"[axis];
  return name;
}

bool parse_order(const std::string& name, EulerOrder& order) {
  for (const EulerOrder& known : all_orders)
    if (order_name(known) == name) {
      order = known;
      return true;
    }
  return false;
}

}  // namespace sinew
