#include "engine/rig/t_pose_motion.h"

#include "engine/model/character_mesh.h"
#include "engine/rig/motion_rig.h"
#include "engine/rig/pose.h"
#include "engine/rig/retarget.h"
#include "engine/rig/t_pose.h"

namespace sinew {
namespace {

/// The skeleton turned so that it stands as VRM asks: up +Y, front +Z.
void stand_up(const BodyAxes& axes, Model& model) {
  const Quat turn = glm::normalize(glm::quat_cast(glm::transpose(Mat3(axes.left, axes.up, axes.front))));
  for (const int root : model.roots) {
    Transform& rest = model.nodes[static_cast<std::size_t>(root)].rest;
    rest.rotation = glm::normalize(turn * rest.rotation);
    rest.translation = turn * rest.translation;
  }
}

}  // namespace

Result<TPoseMotion> t_pose_motion(const Motion& motion) {
  MotionRig rig = motion_rig(motion);
  stand_up(rig.rest_axes, rig.model);
  const auto posed = in_t_pose(rig.model, rig.humanoid);
  if (!posed) return tl::unexpected<Error>(posed.error());
  const std::vector<Mat4> global = global_transforms(*posed, hierarchy_order(*posed), rest_pose(*posed));
  double lowest = INFINITY;
  for (const Mat4& m : global) lowest = std::min(lowest, m[3].y);
  const auto place = [&](HumanoidBone bone) {
    const Vec3 p(global[static_cast<std::size_t>(rig.humanoid.find(bone))][3]);
    return rig.metres_per_unit * Vec3(p.x, p.y - lowest, p.z);
  };

  TPoseMotion out;
  out.model.file = motion.name;
  for (std::size_t i = 0; i < humanoid_bone_count; ++i) {
    const auto bone = static_cast<HumanoidBone>(i);
    if (rig.humanoid.find(bone) < 0 || bone == HumanoidBone::left_eye || bone == HumanoidBone::right_eye) continue;
    const int index = static_cast<int>(out.model.nodes.size());
    out.humanoid.node[i] = index;
    Node& node = out.model.nodes.emplace_back();
    node.name = humanoid_name(bone);
    node.rest.translation = place(bone);
    // Bones stand after their parents in the order of HumanoidBone.
    const auto above = rig.humanoid.parent_present(bone);
    if (!above) {
      out.model.roots.push_back(index);
      continue;
    }
    node.parent = out.humanoid.find(*above);
    node.rest.translation -= place(*above);
    out.model.nodes[static_cast<std::size_t>(node.parent)].children.push_back(index);
  }
  // The same floor under the joints as in the file: feet are joints here, and stand on nothing thicker.
  auto retargeted = retarget(motion, out.model, out.humanoid);
  if (!retargeted) return pass_on(std::move(retargeted));
  out.model.clips.push_back(std::move(retargeted->clip));
  return out;
}

}  // namespace sinew
