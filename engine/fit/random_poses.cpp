#include "engine/fit/random_poses.h"

#include <utility>

#include "engine/rig/humanoid.h"

namespace sinew {
namespace {

/// Degrees from the rest pose about the body's left, up and front, of a bone in the middle or on the left.
struct Limits {
  Vec3 low{-25.0}, high{25.0};
};

Limits limits_of(HumanoidBone bone) {
  using enum HumanoidBone;
  switch (bone) {
    case left_upper_leg:
      return {{-110, -30, -20}, {20, 30, 40}};
    case left_lower_leg:
      return {{0, -5, -2}, {140, 5, 2}};
    case left_foot:
      return {{-15, -10, -15}, {40, 10, 15}};
    case left_toes:
      return {{-45, -2, -2}, {25, 2, 2}};
    case left_shoulder:
      return {{-5, -15, -5}, {5, 15, 25}};
    case left_upper_arm:
      return {{-45, -90, -50}, {45, 30, 60}};
    case left_lower_arm:
      return {{-60, -145, -2}, {60, 0, 2}};
    case left_hand:
      return {{-10, -20, -60}, {10, 20, 60}};
    case left_eye:
      return {{-20, -30, -1}, {20, 30, 1}};
    case jaw:
      return {{0, -3, -1}, {20, 3, 1}};
    default:
      return {};
  }
}

/// Rotations about the up and front axes change their sign in the mirror.
Limits mirrored(const Limits& limits) {
  return {{limits.low.x, -limits.high.y, -limits.high.z}, {limits.high.x, -limits.low.y, -limits.low.z}};
}

std::vector<Limits> node_limits(const Model& model, const Humanoid& humanoid) {
  std::vector<Limits> limits(model.nodes.size());
  for (std::size_t i = 0; i < humanoid_bone_count; ++i) {
    if (humanoid.node[i] < 0) continue;
    const auto bone = static_cast<HumanoidBone>(i);
    const bool right = humanoid_name(bone).starts_with("right");
    limits[humanoid.node[i]] = right ? mirrored(limits_of(mirrored_bone(bone))) : limits_of(bone);
  }
  return limits;
}

}  // namespace

double RandomNumbers::uniform() {
  state_ += 0x9e3779b97f4a7c15u;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1p-53;
}

double RandomNumbers::normal() {
  // Box and Muller 1958; of the two numbers one is used.
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

std::vector<Pose> random_poses(const Model& model, std::span<const int> joints, std::size_t count,
                               RandomNumbers& random) {
  const std::vector<int> order = hierarchy_order(model);
  const Pose rest = rest_pose(model);
  const std::vector<Mat4> global = global_transforms(model, order, rest);
  const std::vector<Quat> turns = rest_rotations(model, order);
  const Humanoid humanoid = find_humanoid(model, global);
  const std::vector<Limits> limits = node_limits(model, humanoid);
  const Vec3 axes[] = {body_left(model, humanoid, global), body_up(model, humanoid, global),
                       body_front(model, humanoid, global)};
  std::vector<Pose> poses(count, rest);
  for (Pose& pose : poses)
    for (const int node : joints) {
      Quat turn(1, 0, 0, 0);
      for (int axis = 0; axis < 3; ++axis) {
        const double degrees = glm::mix(limits[node].low[axis], limits[node].high[axis], random.uniform());
        turn = glm::angleAxis(degrees * degrees_to_radians, axes[axis]) * turn;
      }
      const int parent = model.nodes[node].parent;
      const Quat around = parent < 0 ? Quat(1, 0, 0, 0) : turns[parent];
      pose.local[node].rotation =
          glm::normalize(glm::conjugate(around) * turn * around * model.nodes[node].rest.rotation);
    }
  return poses;
}

}  // namespace sinew
