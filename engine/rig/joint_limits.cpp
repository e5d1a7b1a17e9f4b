#include "engine/rig/joint_limits.h"

#include <algorithm>

#include "engine/core/euler.h"
#include "engine/rig/joint_angle.h"
#include "engine/rig/rest_alignment.h"

namespace sinew {
namespace {

/// Turns that are equal up to rounding.
constexpr double slack_degrees = 1e-6;

/// Directions of a body that stands with its arms to the sides.
enum class Towards { up, down, front, back, outside };

struct BoneLimits {
  HumanoidBone bone;  ///< in the middle or on the left; the right mirrors it
  Towards along;      ///< where the bone points as the ranges are meant
  Towards bend;       ///< where its end goes when it bends
  Towards side;
  DegreeRange bend_degrees, side_degrees, twist_degrees;
};

using B = HumanoidBone;
using T = Towards;
constexpr DegreeRange even(double degrees) { return {-degrees, degrees}; }
constexpr DegreeRange knuckle{-30, 95}, finger{-10, 110}, fingertip{-10, 90};

constexpr BoneLimits table[] = {
    {B::spine, T::up, T::front, T::outside, {-20, 40}, even(25), even(25)},
    {B::chest, T::up, T::front, T::outside, {-15, 35}, even(20), even(25)},
    {B::upper_chest, T::up, T::front, T::outside, {-15, 35}, even(20), even(25)},
    {B::neck, T::up, T::front, T::outside, {-35, 35}, even(30), even(45)},
    {B::head, T::up, T::front, T::outside, {-40, 35}, even(30), even(50)},
    {B::left_shoulder, T::outside, T::front, T::up, even(30), {-15, 45}, even(20)},
    {B::left_upper_arm, T::outside, T::front, T::up, {-50, 140}, {-100, 95}, even(95)},
    {B::left_lower_arm, T::outside, T::front, T::up, {-10, 150}, even(15), even(90)},
    {B::left_hand, T::outside, T::down, T::front, {-70, 80}, {-35, 25}, even(15)},
    {B::left_upper_leg, T::down, T::front, T::outside, {-30, 125}, {-35, 60}, even(50)},
    {B::left_lower_leg, T::down, T::back, T::outside, {-10, 145}, even(12), even(30)},
    {B::left_foot, T::front, T::up, T::outside, {-55, 30}, even(25), even(35)},
    {B::left_toes, T::front, T::up, T::outside, {-45, 75}, even(10), even(10)},
    {B::left_index_proximal, T::outside, T::down, T::front, knuckle, even(20), even(10)},
    {B::left_index_intermediate, T::outside, T::down, T::front, finger, even(10), even(10)},
    {B::left_index_distal, T::outside, T::down, T::front, fingertip, even(10), even(10)},
    {B::left_middle_proximal, T::outside, T::down, T::front, knuckle, even(20), even(10)},
    {B::left_middle_intermediate, T::outside, T::down, T::front, finger, even(10), even(10)},
    {B::left_middle_distal, T::outside, T::down, T::front, fingertip, even(10), even(10)},
    {B::left_ring_proximal, T::outside, T::down, T::front, knuckle, even(20), even(10)},
    {B::left_ring_intermediate, T::outside, T::down, T::front, finger, even(10), even(10)},
    {B::left_ring_distal, T::outside, T::down, T::front, fingertip, even(10), even(10)},
    {B::left_little_proximal, T::outside, T::down, T::front, knuckle, even(20), even(10)},
    {B::left_little_intermediate, T::outside, T::down, T::front, finger, even(10), even(10)},
    {B::left_little_distal, T::outside, T::down, T::front, fingertip, even(10), even(10)}};

/// A turn as twist about the bone, then a swing of the bone: the swing's rotation vector has no part along it.
struct SwingTwist {
  double twist, bend, side;  ///< degrees
};

Quat about(const Vec3& axis, double degrees) { return glm::angleAxis(degrees * degrees_to_radians, axis); }

SwingTwist parted(const JointLimits& limits, const Quat& turn) {
  const Vec3 v(turn.x, turn.y, turn.z);
  const double along = glm::dot(v, limits.along);
  const double twist = std::remainder(2.0 * std::atan2(along, turn.w) * radians_to_degrees, 360.0);
  Quat swing = turn * about(limits.along, -twist);
  if (swing.w < 0.0) swing = -swing;
  const Vec3 s(swing.x, swing.y, swing.z);
  const double angle = 2.0 * std::atan2(glm::length(s), swing.w) * radians_to_degrees;
  const Vec3 vector = angle * unit_or(s, Vec3(0.0));
  return {twist, glm::dot(vector, limits.bend), glm::dot(vector, limits.side)};
}

Quat joined(const JointLimits& limits, const SwingTwist& parts) {
  const Vec3 vector = parts.bend * limits.bend + parts.side * limits.side;
  return about(unit_or(vector, limits.bend), glm::length(vector)) * about(limits.along, parts.twist);
}

double held(const DegreeRange& range, double degrees) { return std::clamp(degrees, range.low, range.high); }
bool holds(const DegreeRange& range, double degrees) {
  return degrees >= range.low - slack_degrees && degrees <= range.high + slack_degrees;
}

}  // namespace

std::optional<JointLimits> joint_limits(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global,
                                        int node) {
  const auto bone_of = std::ranges::find(humanoid.node, node);
  if (node < 0 || bone_of == humanoid.node.end()) return std::nullopt;
  const auto bone = static_cast<HumanoidBone>(bone_of - humanoid.node.begin());
  const auto row = std::ranges::find_if(
      table, [&](const BoneLimits& known) { return known.bone == bone || mirrored_bone(known.bone) == bone; });
  if (row == std::end(table)) return std::nullopt;
  const Vec3 up = body_up(model, humanoid, rest_global), left = body_left(model, humanoid, rest_global),
             front = glm::cross(left, up);
  const auto direction = [&](Towards towards) {
    switch (towards) {
      case Towards::up:
        return up;
      case Towards::down:
        return -up;
      case Towards::front:
        return front;
      case Towards::back:
        return -front;
      case Towards::outside:
        return row->bone == bone ? left : -left;
    }
    return up;
  };
  const Vec3 meant = direction(row->along);
  const auto place = [&](int n) { return Vec3(rest_global[static_cast<std::size_t>(n)][3]); };
  const int next = joint_after(model, humanoid, node);
  JointLimits out;
  out.along = next < 0 ? meant : unit_or(place(next) - place(node), meant);
  // The ranges' directions go along with a bone that rests otherwise than they are meant.
  const Quat carried = turn_between(meant, out.along);
  out.bend = glm::normalize(glm::cross(out.along, carried * direction(row->bend)));
  out.side = glm::normalize(glm::cross(out.along, carried * direction(row->side)));
  out.bend_degrees = row->bend_degrees;
  out.side_degrees = row->side_degrees;
  out.twist_degrees = row->twist_degrees;
  if (row->bone == HumanoidBone::left_upper_arm) {
    const double raised = std::asin(std::clamp(glm::dot(out.along, up), -1.0, 1.0)) * radians_to_degrees;
    out.side_degrees = {out.side_degrees.low - raised, out.side_degrees.high - raised};
  }
  return out;
}

Quat hold_turn(const JointLimits& limits, const Quat& turn) {
  const SwingTwist parts = parted(limits, turn);
  return joined(limits, {held(limits.twist_degrees, parts.twist), held(limits.bend_degrees, parts.bend),
                         held(limits.side_degrees, parts.side)});
}

bool is_within(const JointLimits& limits, const Quat& turn) {
  const SwingTwist parts = parted(limits, turn);
  return holds(limits.twist_degrees, parts.twist) && holds(limits.bend_degrees, parts.bend) &&
         holds(limits.side_degrees, parts.side);
}

Vec3 key_degrees(const Quat& turn, const Vec3& near) {
  const Vec3 zyx = to_euler(turn, {2, 1, 0});
  const Vec3 one = radians_to_degrees * Vec3(zyx.z, zyx.y, zyx.x);
  // The same turn the other way round, each number within half a turn of the nearest.
  Vec3 best(0.0);
  double least = INFINITY;
  for (Vec3 degrees : {one, Vec3(one.x + 180.0, 180.0 - one.y, one.z + 180.0)}) {
    for (int axis = 0; axis < 3; ++axis) degrees[axis] = near[axis] + std::remainder(degrees[axis] - near[axis], 360.0);
    const double far = glm::length(degrees - near);
    if (far < least) least = far, best = degrees;
  }
  return best;
}

DegreeRange number_range(const JointLimits& limits, const Vec3& degrees, int axis) {
  constexpr double step = 1.0, most = 180.0;
  const auto fits = [&](double value) {
    Vec3 asked = degrees;
    asked[axis] = value;
    return is_within(limits, rotation_xyz_degrees(asked));
  };
  if (!fits(degrees[axis])) return {};
  DegreeRange range{degrees[axis], degrees[axis]};
  while (range.low - step >= -most && fits(range.low - step)) range.low -= step;
  while (range.high + step <= most && fits(range.high + step)) range.high += step;
  return range;
}

}  // namespace sinew
