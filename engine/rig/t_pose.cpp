#include "engine/rig/t_pose.h"

#include <map>
#include <set>
#include <string>

#include "engine/model/character_mesh.h"
#include "engine/rig/pose.h"

namespace sinew {
namespace {

using enum HumanoidBone;

/// Turned by more than this away from +Z, a model is turned back; less is how its joints happen to lie.
constexpr double least_yaw = 20.0;

/// The shortest turn that takes one direction to another.
Quat turn_between(const Vec3& from, const Vec3& to) {
  const Vec3 axis = glm::cross(from, to);
  const double angle = angle_degrees(from, to) * degrees_to_radians;
  // Opposite directions have no shortest turn; a limb is never posed that way.
  return glm::angleAxis(angle, unit_or(axis, Vec3(0, 1, 0)));
}

/// What each bone of a limb points along in the T pose.
std::map<int, std::pair<int, Vec3>> directions(const Humanoid& humanoid) {
  std::map<int, std::pair<int, Vec3>> out;  // node -> next node, direction
  const auto point = [&](HumanoidBone bone, HumanoidBone next, const Vec3& direction) {
    if (humanoid.find(bone) >= 0 && humanoid.find(next) >= 0)
      out[humanoid.find(bone)] = {humanoid.find(next), direction};
  };
  const Vec3 left(1, 0, 0), down(0, -1, 0);
  point(left_upper_arm, left_lower_arm, left);
  point(left_lower_arm, left_hand, left);
  point(left_hand, left_middle_proximal, left);
  point(right_upper_arm, right_lower_arm, -left);
  point(right_lower_arm, right_hand, -left);
  point(right_hand, right_middle_proximal, -left);
  point(left_upper_leg, left_lower_leg, down);
  point(left_lower_leg, left_foot, down);
  point(right_upper_leg, right_lower_leg, down);
  point(right_lower_leg, right_foot, down);
  return out;
}

/// How much each node is turned in the world, against the rest pose.
std::vector<Quat> world_turns(const Model& model, const Humanoid& humanoid, std::span<const int> order,
                              std::span<const Mat4> rest) {
  const Vec3 front = body_front(model, humanoid, rest);
  const double yaw = std::atan2(front.x, front.z);
  const bool turned = std::abs(yaw) > least_yaw * degrees_to_radians;
  const Quat upright = turned ? glm::angleAxis(-yaw, Vec3(0, 1, 0)) : Quat(1, 0, 0, 0);
  const auto pointing = directions(humanoid);
  std::vector<Quat> turns(model.nodes.size(), upright);
  for (const int node : order) {
    if (model.nodes[node].parent >= 0) turns[node] = turns[model.nodes[node].parent];
    if (node == humanoid.find(left_foot) || node == humanoid.find(right_foot)) turns[node] = upright;
    const auto found = pointing.find(node);
    if (found == pointing.end()) continue;
    const auto& [next, direction] = found->second;
    const Vec3 now = turns[node] * Vec3(rest[next][3] - rest[node][3]);
    turns[node] = turn_between(now, direction) * turns[node];
  }
  return turns;
}

/// One skinned primitive as the palette shows it.
void bake(Primitive& primitive, std::span<const Mat4> palette) {
  for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
    const std::uint32_t first = primitive.influences.first[v], last = primitive.influences.first[v + 1];
    if (first == last) continue;
    Mat4 blend(0.0);
    for (std::uint32_t k = first; k < last; ++k)
      blend += primitive.influences.entries[k].weight * palette[primitive.influences.entries[k].joint];
    const Mat3 linear(blend), to_normal = cofactor(linear);
    const double side = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
    primitive.positions[v] = Vec3(blend * Vec4(primitive.positions[v], 1.0));
    const Vec3 normal = unit_or(side * (to_normal * primitive.normals[v]), primitive.normals[v]);
    for (MorphTarget& target : primitive.morph_targets) {
      if (!target.positions.empty()) target.positions[v] = linear * target.positions[v];
      if (!target.normals.empty()) {
        const Vec3 moved = primitive.normals[v] + target.normals[v];
        target.normals[v] = unit_or(side * (to_normal * moved), normal) - normal;
      }
    }
    primitive.normals[v] = normal;
  }
}

std::string names_of(const std::vector<HumanoidBone>& bones) {
  std::string out;
  for (const HumanoidBone bone : bones) out += (out.empty() ? "" : ", ") + std::string(humanoid_name(bone));
  return out;
}

}  // namespace

Result<Model> in_t_pose(const Model& model, const Humanoid& humanoid) {
  if (!humanoid.complete())
    return bad_input("{}: a T pose needs a complete humanoid, and joints are missing: {}", model.file,
                     names_of(humanoid.missing_required()));
  std::map<int, int> skin_of_mesh;
  for (const Node& node : model.nodes) {
    if (node.mesh < 0 || node.skin < 0) continue;
    const auto [place, is_new] = skin_of_mesh.try_emplace(node.mesh, node.skin);
    if (!is_new && place->second != node.skin)
      return bad_input("{}: meshes/{} is skinned by skins/{} and skins/{}: in a T pose it would be two meshes",
                       model.file, node.mesh, place->second, node.skin);
  }
  const std::vector<int> order = hierarchy_order(model);
  const std::vector<Mat4> rest = global_transforms(model, order, rest_pose(model));
  const std::vector<Quat> rotations = rest_rotations(model, order);
  const std::vector<Quat> turns = world_turns(model, humanoid, order, rest);

  Model out = model;
  out.clips.clear();
  for (const int node : order) {
    const int parent = model.nodes[node].parent;
    const Quat above = parent >= 0 ? rotations[parent] : Quat(1, 0, 0, 0);
    const Quat turned_above = parent >= 0 ? turns[parent] : Quat(1, 0, 0, 0);
    Transform& local = out.nodes[node].rest;
    local.rotation = glm::normalize(glm::inverse(above) * glm::inverse(turned_above) * turns[node] * above *
                                    model.nodes[node].rest.rotation);
    if (parent < 0) local.translation = turns[node] * local.translation;
  }
  std::vector<Mat4> posed = global_transforms(out, order, rest_pose(out));
  double lowest = INFINITY;
  for (const auto& [mesh, skin] : skin_of_mesh) {
    std::vector<Mat4> palette;
    for (std::size_t j = 0; j < out.skins[skin].joints.size(); ++j)
      palette.push_back(posed[out.skins[skin].joints[j]] * model.skins[skin].inverse_bind[j]);
    for (Primitive& primitive : out.meshes[mesh].primitives) {
      if (primitive.influences.vertices() == 0) continue;
      bake(primitive, palette);
      for (const Vec3& p : primitive.positions) lowest = std::min(lowest, p.y);
    }
  }
  if (!std::isfinite(lowest)) lowest = 0.0;
  for (const int root : out.roots) {
    // A skinned mesh ignores its own node; what hangs from a root stands on the ground with it.
    out.nodes[root].rest.translation.y -= lowest;
  }
  for (const auto& [mesh, skin] : skin_of_mesh)
    for (Primitive& primitive : out.meshes[mesh].primitives)
      if (primitive.influences.vertices() > 0)
        for (Vec3& p : primitive.positions) p.y -= lowest;
  posed = global_transforms(out, order, rest_pose(out));
  for (Skin& skin : out.skins)
    for (std::size_t j = 0; j < skin.joints.size(); ++j) skin.inverse_bind[j] = glm::inverse(posed[skin.joints[j]]);
  return out;
}

}  // namespace sinew
