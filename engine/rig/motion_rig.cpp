#include "engine/rig/motion_rig.h"

#include <algorithm>

#include "engine/model/character_mesh.h"
#include "engine/rig/joint_tree.h"
#include "engine/rig/pose.h"

namespace sinew {
namespace {

using enum HumanoidBone;

/// Hips over ankles of a grown body of 1.70 m: 0.53 of its height over the soles, the ankles 0.04 of it over them.
constexpr double usual_hip_height = 0.83;
/// Within these a body is believed to have the size that its file states.
constexpr double least_hip_height = 0.2, most_hip_height = 2.0;

Vec3 nearest_axis(const Vec3& v, double within_degrees) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      Vec3 direction(0.0);
      direction[axis] = sign;
      if (angle_degrees(v, direction) <= within_degrees) return direction;
    }
  return v;
}

Vec3 place(std::span<const Mat4> global, int node) { return Vec3(global[static_cast<std::size_t>(node)][3]); }

/// The axis of the file that the body's own up points along most of the time, where the root's height agrees; else the
/// rest pose's.
Vec3 world_up(const Motion& motion, const MotionRig& rig, std::vector<std::string>& notes) {
  const int hip = rig.humanoid.find(hips);
  const Vec3 rest_up = nearest_axis(rig.rest_axes.up, 45.0);
  if (hip < 0 || hip >= static_cast<int>(motion.skeleton.joints.size())) return rest_up;
  const Quat rest = motion_rest(motion.skeleton).rotations[static_cast<std::size_t>(hip)];
  constexpr std::size_t most_samples = 200;
  const std::size_t step = motion.frames.size() / most_samples + 1;
  Vec3 mean_up(0.0), mean_place(0.0);
  double samples = 0.0;
  for (std::size_t f = 0; f < motion.frames.size(); f += step, samples += 1.0) {
    const MotionPose pose = motion_pose(motion, f);
    mean_up += pose.rotations[static_cast<std::size_t>(hip)] * glm::conjugate(rest) * rig.rest_axes.up;
    mean_place += pose.places[static_cast<std::size_t>(hip)];
  }
  mean_up /= samples;
  mean_place /= samples;
  const Vec3 up = nearest_axis(mean_up, 45.0);
  if (up == rest_up || glm::length(mean_up) < 0.5 || up == mean_up) return rest_up;
  // A body that lies has its up along a level axis; it is its height that tells it from one whose file has another up.
  const double standing = 0.4 * rig.height;
  if (!(glm::dot(mean_place, up) > standing && glm::dot(mean_place, rest_up) < standing)) return rest_up;
  notes.push_back(fmt::format("up is the file's {}{}: the body stands along it, though its rest pose does not",
                              up.x + up.y + up.z < 0 ? "-" : "+",
                              up.x != 0   ? 'x'
                              : up.y != 0 ? 'y'
                                          : 'z'));
  return up;
}

double scale_of(const MotionRig& rig, const MotionSkeleton& skeleton, std::vector<std::string>& notes) {
  if (skeleton.metres_per_unit) {
    const double metres = rig.height * *skeleton.metres_per_unit;
    if (rig.height == 0.0 || (metres > least_hip_height && metres < most_hip_height)) return *skeleton.metres_per_unit;
    notes.push_back(fmt::format("the unit of {:.4g} m that the file states makes hips {:.4g} m high: not believed",
                                *skeleton.metres_per_unit, metres));
  }
  return rig.height > 0.0 ? usual_hip_height / rig.height : 1.0;
}

}  // namespace

Model skeleton_model(const MotionSkeleton& skeleton) {
  Model model;
  const auto add = [&](const std::string& name, int parent, const Vec3& offset, const Quat& rotation) {
    const int index = static_cast<int>(model.nodes.size());
    Node& node = model.nodes.emplace_back();
    node.name = name;
    node.parent = parent;
    node.rest.translation = offset;
    node.rest.rotation = rotation;
    if (parent >= 0)
      model.nodes[static_cast<std::size_t>(parent)].children.push_back(index);
    else
      model.roots.push_back(index);
  };
  for (const MotionJoint& joint : skeleton.joints) add(joint.name, joint.parent, joint.offset, joint.rest_rotation);
  for (std::size_t j = 0; j < skeleton.joints.size(); ++j)
    if (const auto& end = skeleton.joints[j].end) add("", static_cast<int>(j), *end, Quat(1, 0, 0, 0));
  model.vrm_bones = skeleton.humanoid;
  return model;
}

MotionPose motion_pose(const Motion& motion, std::size_t index) {
  const std::vector<MotionJoint>& joints = motion.skeleton.joints;
  const MotionFrame& frame = motion.frames[index];
  MotionPose pose;
  pose.rotations.reserve(joints.size());
  pose.places.reserve(joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].parent < 0) {
      pose.rotations.push_back(frame.rotations[j]);
      pose.places.push_back(frame.root);
      continue;
    }
    const auto parent = static_cast<std::size_t>(joints[j].parent);
    const Vec3& offset = frame.offsets.empty() ? joints[j].offset : frame.offsets[j];
    pose.rotations.push_back(glm::normalize(pose.rotations[parent] * frame.rotations[j]));
    pose.places.push_back(pose.places[parent] + pose.rotations[parent] * offset);
  }
  return pose;
}

MotionPose motion_rest(const MotionSkeleton& skeleton) {
  Motion rest;
  rest.skeleton.joints = skeleton.joints;
  MotionFrame& frame = rest.frames.emplace_back();
  frame.root = skeleton.joints.front().offset;
  for (const MotionJoint& joint : skeleton.joints) frame.rotations.push_back(joint.rest_rotation);
  return motion_pose(rest, 0);
}

std::vector<int> joints_between(const Model& model, const Humanoid& humanoid, HumanoidBone lower, HumanoidBone upper) {
  const int bottom = humanoid.find(lower);
  std::vector<int> chain;
  for (int node = humanoid.find(upper); node >= 0 && node != bottom;
       node = model.nodes[static_cast<std::size_t>(node)].parent)
    chain.insert(chain.begin(), node);
  const bool reached =
      !chain.empty() && bottom >= 0 && model.nodes[static_cast<std::size_t>(chain.front())].parent == bottom;
  return reached ? chain : std::vector<int>{};
}

BodyAxes standing_axes(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global) {
  BodyAxes axes;
  axes.up = nearest_axis(body_up(model, humanoid, rest_global), 25.0);
  const Vec3 left = body_left(model, humanoid, rest_global);
  const Vec3 level = unit_or(left - axes.up * glm::dot(left, axes.up), Vec3(1, 0, 0));
  axes.left = nearest_axis(level, 15.0);
  // An axis that is not the file's own may leave the other askew by a little.
  axes.left = unit_or(axes.left - axes.up * glm::dot(axes.left, axes.up), level);
  axes.front = glm::cross(axes.left, axes.up);
  return axes;
}

double hip_height(const Humanoid& humanoid, std::span<const Mat4> rest_global, const Vec3& up) {
  double highest = 0.0;
  for (const auto& [thigh, shin, ankle] : {std::array{left_upper_leg, left_lower_leg, left_foot},
                                           std::array{right_upper_leg, right_lower_leg, right_foot}}) {
    const int hip = humanoid.find(hips), t = humanoid.find(thigh), s = humanoid.find(shin), a = humanoid.find(ankle);
    if (hip < 0 || t < 0 || s < 0 || a < 0) continue;
    const double drop = glm::dot(place(rest_global, hip) - place(rest_global, t), up);
    highest = std::max(highest, drop + glm::length(place(rest_global, t) - place(rest_global, s)) +
                                    glm::length(place(rest_global, s) - place(rest_global, a)));
  }
  return highest;
}

MotionRig motion_rig(const Motion& motion) {
  MotionRig rig;
  rig.model = skeleton_model(motion.skeleton);
  rig.model.file = motion.name;
  rig.rest_global = global_transforms(rig.model, hierarchy_order(rig.model), rest_pose(rig.model));
  rig.humanoid = find_humanoid(rig.model, rig.rest_global);
  rig.notes = rig.humanoid.notes;
  rig.rest_axes = standing_axes(rig.model, rig.humanoid, rig.rest_global);
  rig.height = hip_height(rig.humanoid, rig.rest_global, rig.rest_axes.up);
  rig.up = world_up(motion, rig, rig.notes);
  rig.metres_per_unit = scale_of(rig, motion.skeleton, rig.notes);
  return rig;
}

}  // namespace sinew
