#include "engine/rig/pose.h"

namespace sinew {
namespace {

Mat4 local_matrix(const Node& node, const Transform& local) {
  if (!node.matrix) return local.matrix();
  // A sheared matrix is kept whole; only what turns or moves it from its rest is put in front.
  Mat4 m = glm::mat4_cast(local.rotation * glm::conjugate(node.rest.rotation)) * Mat4(Mat3(*node.matrix));
  m[3] = Vec4(local.translation, 1.0);
  return m;
}

}  // namespace

Pose rest_pose(const Model& model) {
  Pose pose;
  for (const Node& node : model.nodes) {
    pose.local.push_back(node.rest);
    std::vector<double> weights = node.morph_weights;
    if (weights.empty() && node.mesh >= 0) weights = model.meshes[node.mesh].morph_weights;
    if (node.mesh >= 0 && !model.meshes[node.mesh].primitives.empty())
      weights.resize(model.meshes[node.mesh].primitives.front().morph_targets.size());
    pose.morph_weights.push_back(std::move(weights));
  }
  return pose;
}

std::vector<Mat4> global_transforms(const Model& model, std::span<const int> order, const Pose& pose) {
  std::vector<Mat4> global(model.nodes.size());
  for (int i : order) {
    const Node& node = model.nodes[i];
    const Mat4 local = local_matrix(node, pose.local[i]);
    global[i] = node.parent >= 0 ? global[node.parent] * local : local;
  }
  return global;
}

std::vector<Quat> rest_rotations(const Model& model, std::span<const int> order) {
  std::vector<Quat> global(model.nodes.size());
  for (int i : order) {
    const Node& node = model.nodes[i];
    global[i] = node.parent >= 0 ? glm::normalize(global[node.parent] * node.rest.rotation) : node.rest.rotation;
  }
  return global;
}

void turn_joint(const Model& model, std::span<const Quat> rest_rotations, int node, const Vec3& degrees, Pose& pose) {
  pose.local[node].rotation = model.nodes[node].rest.rotation;
  turn_joint_further(model, rest_rotations, node, degrees, pose);
}

void turn_joint_further(const Model& model, std::span<const Quat> rest_rotations, int node, const Vec3& degrees,
                        Pose& pose) {
  const int parent = model.nodes[node].parent;
  const Quat w = parent >= 0 ? rest_rotations[parent] : Quat(1, 0, 0, 0);
  pose.local[node].rotation =
      glm::normalize(glm::conjugate(w) * rotation_xyz_degrees(degrees) * w * pose.local[node].rotation);
}

void blend_pose(const Pose& towards, double weight, Pose& pose) {
  for (std::size_t i = 0; i < pose.local.size(); ++i) {
    Transform& local = pose.local[i];
    const Transform& other = towards.local[i];
    local.translation = glm::mix(local.translation, other.translation, weight);
    local.rotation = glm::normalize(glm::slerp(local.rotation, other.rotation, weight));
    local.scale = glm::mix(local.scale, other.scale, weight);
    for (std::size_t k = 0; k < pose.morph_weights[i].size(); ++k)
      pose.morph_weights[i][k] = std::lerp(pose.morph_weights[i][k], towards.morph_weights[i][k], weight);
  }
}

std::vector<Mat34> palette_transforms(const CharacterMesh& mesh, std::span<const Mat4> global, const Mat4& placement) {
  std::vector<Mat34> palette;
  palette.reserve(mesh.palette.size());
  for (const PaletteSource& source : mesh.palette)
    palette.push_back(Mat34::from(placement * global[source.node] * source.inverse_bind));
  return palette;
}

std::vector<double> morph_slot_weights(const CharacterMesh& mesh, const Pose& pose) {
  std::vector<double> weights;
  weights.reserve(mesh.morph_slots.size());
  for (const MorphSlot& slot : mesh.morph_slots) {
    const std::vector<double>& of_node = pose.morph_weights[slot.node];
    weights.push_back(slot.target < of_node.size() ? of_node[slot.target] : 0.0);
  }
  return weights;
}

}  // namespace sinew
