#include "engine/rig/limb_reach.h"

#include <algorithm>

#include "engine/rig/rest_alignment.h"

namespace sinew {

std::optional<Limb> find_limb(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global,
                              HumanoidBone end) {
  const auto lower = parent_bone(end);
  const auto upper = lower ? parent_bone(*lower) : std::nullopt;
  if (!upper) return std::nullopt;
  Limb limb{end, humanoid.find(*upper), humanoid.find(*lower), humanoid.find(end), {}, {}};
  const auto upper_limits = joint_limits(model, humanoid, rest_global, limb.upper),
             lower_limits = joint_limits(model, humanoid, rest_global, limb.lower);
  if (limb.end < 0 || !upper_limits || !lower_limits) return std::nullopt;
  limb.upper_limits = *upper_limits;
  limb.lower_limits = *lower_limits;
  return limb;
}

LimbTurns reach(const Limb& limb, const TurnedJoint& upper, const TurnedJoint& lower, const Vec3& end,
                const Vec3& target) {
  // In the axes that the lower joint is turned about: the upper bone, and the lower one without its turn.
  const Quat to_axes = glm::conjugate(lower.carried);
  const Vec3 u = to_axes * (lower.place - upper.place),
             d = glm::conjugate(lower.turn) * (to_axes * (end - lower.place));
  const Vec3 hinge = limb.lower_limits.bend;
  // |u + R(phi) d|^2 = |target|^2, where u . R(phi) d = a cos(phi) + b sin(phi) + c.
  const double c = glm::dot(hinge, d) * glm::dot(u, hinge), a = glm::dot(u, d) - c,
               b = glm::dot(u, glm::cross(hinge, d));
  const double distance = glm::distance(target, upper.place);
  const double wanted = 0.5 * (distance * distance - glm::dot(u, u) - glm::dot(d, d));
  const double size = std::hypot(a, b);
  if (size <= 0.0 || distance <= 0.0) return {upper.turn, lower.turn};
  const double straight = std::atan2(b, a), opening = std::acos(std::clamp((wanted - c) / size, -1.0, 1.0));
  const DegreeRange& range = limb.lower_limits.bend_degrees;
  const double bent = std::clamp((straight + opening) * radians_to_degrees, range.low, range.high);
  const Quat bend = glm::angleAxis(bent * degrees_to_radians, hinge);

  LimbTurns out;
  const Vec3& along = limb.lower_limits.along;
  const double part = lower.turn.x * along.x + lower.turn.y * along.y + lower.turn.z * along.z;
  const Quat twist = glm::angleAxis(2.0 * std::atan2(part, lower.turn.w), along);
  out.lower = glm::normalize(bend * twist);
  const Vec3 came = lower.place + lower.carried * (out.lower * d) - upper.place;
  const Quat swing = turn_between(unit_or(came, along), (target - upper.place) / distance);
  out.upper = glm::normalize(glm::conjugate(upper.carried) * swing * upper.carried * upper.turn);
  if (is_within(limb.upper_limits, upper.turn)) out.upper = hold_turn(limb.upper_limits, out.upper);
  return out;
}

}  // namespace sinew
