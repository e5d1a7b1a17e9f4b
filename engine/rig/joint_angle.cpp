#include "engine/rig/joint_angle.h"

namespace sinew {
namespace {

std::optional<HumanoidBone> bone_of(const Humanoid& humanoid, int node) {
  for (std::size_t i = 0; i < humanoid.node.size(); ++i)
    if (humanoid.node[i] == node) return static_cast<HumanoidBone>(i);
  return std::nullopt;
}

int node_before(const Model& model, const Humanoid& humanoid, int node) {
  if (const auto bone = bone_of(humanoid, node))
    if (const auto parent = humanoid.parent_present(*bone)) return humanoid.find(*parent);
  return model.nodes[node].parent;
}

}  // namespace

int joint_after(const Model& model, const Humanoid& humanoid, int node) {
  if (const auto bone = bone_of(humanoid, node))
    if (const auto next = humanoid.next_present(*bone)) return humanoid.find(*next);
  const std::vector<int>& children = model.nodes[node].children;
  return children.empty() ? -1 : children.front();
}

double JointAngle::degrees(std::span<const Mat4> global) const {
  const Vec3 joint(global[at][3]);
  return angle_degrees(Vec3(global[before][3]) - joint, Vec3(global[after][3]) - joint);
}

std::optional<JointAngle> driver_angle(const Model& model, const Humanoid& humanoid, int driver, int tip, int before) {
  JointAngle angle;
  angle.at = driver;
  angle.before = before >= 0 ? before : node_before(model, humanoid, driver);
  angle.after = tip >= 0 ? tip : joint_after(model, humanoid, driver);
  if (angle.before < 0 || angle.after < 0) return std::nullopt;
  return angle;
}

double muscle_activation(double angle, double rest_angle, double reference_angle) {
  const double delta = (rest_angle - angle) / (rest_angle - reference_angle);
  return delta < 1e-9 ? 0.0 : delta;
}

double muscle_activation(const Muscle& muscle, double angle) {
  return muscle.on ? muscle_activation(angle, muscle.rest_angle, muscle.reference_angle) : 0.0;
}

}  // namespace sinew
