#include "engine/body/belly_side.h"

namespace sinew {
namespace {

/// A rest pose bent by more than this shows by itself which side flexes.
constexpr double telling_bend_degrees = 5.0;

/// What the directions are measured on.
struct Limb {
  const Model& model;
  const Humanoid& humanoid;
  std::span<const Mat4> global;
  const Muscle& muscle;
  bool left;

  Vec3 place(int node) const { return Vec3(global[node][3]); }
  Vec3 axis() const { return unit_or(place(muscle.child) - place(muscle.bone), Vec3(0.0)); }
  Vec3 front() const { return body_front(model, humanoid, global); }
  /// A joint of the limb's own side, or -1.
  int own(HumanoidBone left_bone) const { return humanoid.find(left ? left_bone : mirrored_bone(left_bone)); }
};

/// Towards the inside of the bend at the bone's far end, across the bone; nothing where the limb is straight.
std::optional<Vec3> flexor_side(const Limb& limb, const std::optional<JointAngle>& bend) {
  if (!bend || 180.0 - bend->degrees(limb.global) < telling_bend_degrees) return std::nullopt;
  const Vec3 axis = limb.axis();
  const Vec3 beyond = limb.place(bend->after) - limb.place(limb.muscle.child);
  return unit_or(beyond - glm::dot(beyond, axis) * axis, Vec3(0.0));
}

/// At right angles to the fingers and to the line from little finger (or wrist) to index finger (or thumb). A model
/// without fingers does not tell.
std::optional<Vec3> palm_side(const Limb& limb) {
  const int hand = limb.own(HumanoidBone::left_hand), middle = limb.own(HumanoidBone::left_middle_proximal),
            index = limb.own(HumanoidBone::left_index_proximal), little = limb.own(HumanoidBone::left_little_proximal),
            ring = limb.own(HumanoidBone::left_ring_proximal), thumb = limb.own(HumanoidBone::left_thumb_proximal);
  const int finger = middle >= 0 ? middle : index;
  if (hand < 0 || finger < 0) return std::nullopt;
  const Vec3 along = limb.place(finger) - limb.place(hand);
  const int outermost = little >= 0 ? little : ring;
  const int thumbward = index >= 0 && outermost >= 0 ? index : thumb;
  if (thumbward < 0) return std::nullopt;
  const Vec3 towards_thumb =
      limb.place(thumbward) - limb.place(outermost >= 0 && thumbward == index ? outermost : hand);
  const Vec3 palm = unit_or(glm::cross(along, towards_thumb), Vec3(0.0));
  if (palm == Vec3(0.0)) return std::nullopt;
  return limb.left ? palm : -palm;
}

Vec3 chest_side(const Limb& limb) {
  const Vec3 left = body_left(limb.model, limb.humanoid, limb.global);
  return limb.front() + 0.3 * (limb.left ? left : -left);
}

Vec3 outer_side(const Limb& limb) {
  const Vec3 left = body_left(limb.model, limb.humanoid, limb.global);
  return body_up(limb.model, limb.humanoid, limb.global) + (limb.left ? left : -left);
}

/// The side, or nothing where the model does not tell it.
std::optional<Vec3> told(const Limb& limb, const std::optional<JointAngle>& bend, BellySide side) {
  // A limb nearer than 30 degrees to the body's front has no front of its own.
  const auto across = [&](const Vec3& direction) -> std::optional<Vec3> {
    if (std::abs(glm::dot(direction, limb.axis())) > 0.866) return std::nullopt;
    return direction;
  };
  switch (side) {
    case BellySide::flexor:
      return flexor_side(limb, bend);
    case BellySide::extensor:
      if (const auto inside = flexor_side(limb, bend)) return -*inside;
      return std::nullopt;
    case BellySide::front:
      return across(limb.front());
    case BellySide::back:
      return across(-limb.front());
    case BellySide::palm:
      return palm_side(limb);
    case BellySide::front_outer:
      return chest_side(limb);
    case BellySide::outer:
      return outer_side(limb);
  }
  return std::nullopt;
}

}  // namespace

Vec3 belly_direction(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global,
                     const Muscle& muscle, const std::optional<JointAngle>& bend, bool left, BellySide side,
                     BellySide otherwise) {
  const Limb limb{model, humanoid, rest_global, muscle, left};
  if (const auto direction = told(limb, bend, side)) return *direction;
  if (const auto direction = told(limb, bend, otherwise)) return *direction;
  return side == BellySide::back ? -limb.front() : limb.front();
}

}  // namespace sinew
