#include "engine/rig/rest_alignment.h"

namespace sinew {
namespace {

using enum HumanoidBone;

std::size_t at(int node) { return static_cast<std::size_t>(node); }

/// From the bone's joint to the next one of the chain, where both are there and apart.
std::optional<Vec3> direction(const RestBody& body, HumanoidBone bone, HumanoidBone next) {
  const int a = body.humanoid.find(bone), b = body.humanoid.find(next);
  if (a < 0 || b < 0) return std::nullopt;
  const Vec3 along(body.global[at(b)][3] - body.global[at(a)][3]);
  if (glm::length(along) == 0.0) return std::nullopt;
  return glm::normalize(along);
}

bool aligned(HumanoidBone bone) {
  if (bone >= left_thumb_metacarpal) return true;
  switch (bone) {
    case left_upper_arm:
    case left_lower_arm:
    case left_hand:
    case right_upper_arm:
    case right_lower_arm:
    case right_hand:
    case left_upper_leg:
    case left_lower_leg:
    case right_upper_leg:
    case right_lower_leg:
      return true;
    default:
      return false;
  }
}

/// The turn that takes a foot of a standing body to where `like` holds it.
Quat foot_turn(const RestBody& body, const RestBody& like, const Quat& upright, bool left) {
  const HumanoidBone thigh = left ? left_upper_leg : right_upper_leg, foot = left ? left_foot : right_foot;
  const HumanoidBone toes = left ? left_toes : right_toes;
  const auto leg = direction(like, thigh, foot);
  // Ankles stand a little aside of the hips in any body; a leg that is held askew takes its foot along.
  constexpr double straight = 10.0;
  const Vec3 down = -like.axes.up;
  const Quat askew = leg && angle_degrees(*leg, down) > straight ? turn_between(down, *leg) : Quat(1, 0, 0, 0);
  const Quat turned = askew * upright;
  const auto own = direction(body, foot, toes), wanted = direction(like, foot, toes);
  if (!own || !wanted) return turned;
  const Vec3 axis = askew * like.axes.up;
  const auto level = [&](const Vec3& v) { return v - axis * glm::dot(v, axis); };
  const Vec3 from = level(turned * *own), to = level(*wanted);
  if (glm::length(from) < 0.2 || glm::length(to) < 0.2) return turned;
  const double sign = glm::dot(glm::cross(from, to), axis) < 0.0 ? -1.0 : 1.0;
  return glm::angleAxis(sign * angle_degrees(from, to) * degrees_to_radians, axis) * turned;
}

Mat3 frame(const BodyAxes& axes) { return {axes.left, axes.up, axes.front}; }

}  // namespace

Quat turn_between(const Vec3& from, const Vec3& to) {
  const Vec3 across = std::abs(from.y) < 0.9 * glm::length(from) ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
  const Vec3 axis = unit_or(glm::cross(from, to), unit_or(glm::cross(from, across), Vec3(0, 1, 0)));
  return glm::angleAxis(angle_degrees(from, to) * degrees_to_radians, axis);
}

std::vector<Quat> rest_alignment(const RestBody& body, const RestBody& like, std::span<const int> order) {
  const Quat upright = glm::normalize(glm::quat_cast(frame(like.axes) * glm::transpose(frame(body.axes))));
  std::vector<std::optional<HumanoidBone>> bone_of(body.model.nodes.size());
  for (std::size_t i = 0; i < humanoid_bone_count; ++i)
    if (body.humanoid.node[i] >= 0) bone_of[at(body.humanoid.node[i])] = static_cast<HumanoidBone>(i);

  std::vector<Quat> turns(body.model.nodes.size(), upright);
  for (const int node : order) {
    const int parent = body.model.nodes[at(node)].parent;
    if (parent >= 0) turns[at(node)] = turns[at(parent)];
    const auto bone = bone_of[at(node)];
    if (!bone) continue;
    if (*bone == left_foot || *bone == right_foot) {
      turns[at(node)] = foot_turn(body, like, upright, *bone == left_foot);
      continue;
    }
    const auto next = body.humanoid.next_present(*bone);
    if (!aligned(*bone) || !next) continue;
    const auto own = direction(body, *bone, *next), wanted = direction(like, *bone, *next);
    if (own && wanted) turns[at(node)] = turn_between(turns[at(node)] * *own, *wanted) * turns[at(node)];
  }
  return turns;
}

}  // namespace sinew
