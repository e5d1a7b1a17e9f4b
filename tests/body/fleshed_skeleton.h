#pragma once
/// Human skeletons made by hand, with a tube of flesh round each upper arm and lower leg, and what places muscles on
/// them.

#include <initializer_list>
#include <string>

#include "engine/body/muscle_placement.h"
#include "engine/model/character_mesh.h"
#include "tests/rig/humanoid_skeletons.h"

namespace sinew::test {

constexpr double arm_radius = 0.05, leg_radius = 0.06;

/// A tube from joint to joint, all of it on the first one. No vertex stands where a preset's region ends: on which side
/// of an edge it lies would be a matter of rounding.
inline void add_flesh(const std::vector<Mat4>& global, int node, int child, double radius, Primitive& skin) {
  constexpr std::size_t rings = 38, columns = 32;
  const Vec3 from(global[node][3]), to(global[child][3]), axis = glm::normalize(to - from);
  // Started from the front, so that left and right limbs have vertices at mirrored places.
  const Vec3 front = glm::normalize(Vec3(0, 0, 1) - axis.z * axis), side = glm::cross(front, axis);
  for (std::size_t ring = 0; ring < rings; ++ring)
    for (std::size_t column = 0; column < columns; ++column) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(column) / columns;
      const Vec3 out = std::cos(angle) * front + std::sin(angle) * side;
      const double along = 0.01 + 0.98 * static_cast<double>(ring) / (rings - 1);
      skin.positions.push_back(glm::mix(from, to, along) + radius * out);
      skin.normals.push_back(out);
      skin.influences.add_vertex({{static_cast<std::uint32_t>(node), 1.0}});
    }
}

/// The skeleton with flesh; its rest pose is the bind pose.
inline Model fleshed(Model model) {
  link_children(model);
  const std::vector<Mat4> global = rest_transforms(model);
  const Humanoid humanoid = find_humanoid(model, global);
  Primitive skin;
  for (const auto& [bone, child, radius] : {std::tuple(left_upper_arm, left_lower_arm, arm_radius),
                                            {right_upper_arm, right_lower_arm, arm_radius},
                                            {left_lower_leg, left_foot, leg_radius},
                                            {right_lower_leg, right_foot, leg_radius}})
    add_flesh(global, humanoid.find(bone), humanoid.find(child), radius, skin);
  skin.indices = {0, 1, 2};
  Skin joints;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    joints.joints.push_back(static_cast<int>(i));
    joints.inverse_bind.push_back(glm::inverse(global[i]));
  }
  Node drawn;
  drawn.name = "flesh";
  drawn.mesh = drawn.skin = 0;
  model.meshes = {{"flesh", {skin}, {}}};
  model.skins = {joints};
  model.nodes.push_back(drawn);
  link_children(model);
  return model;
}

/// Where elbow and hand of the left arm stand, those of the right arm mirrored.
struct ArmPlaces {
  Vec3 elbow{0.46, 1.43, -0.01}, hand{0.72, 1.43, 0.0};
};

/// A human in a T-pose that faces +Z, with these arms.
inline Model arms_of(const ArmPlaces& places) {
  Model model = build(convention("VRM")).model;
  for (Node& node : model.nodes) {
    const Vec3 side = node.name.starts_with("right") ? Vec3(-1, 1, 1) : Vec3(1);
    if (node.name.ends_with("LowerArm")) node.rest.translation = side * (places.elbow - Vec3(0.18, 1.43, 0));
    if (node.name.ends_with("Hand")) node.rest.translation = side * (places.hand - places.elbow);
  }
  return fleshed(model);
}

/// A character as muscles are placed on it.
struct Fleshed {
  explicit Fleshed(Model m)
      : model(std::move(m)),
        mesh((link_children(model), character_mesh(model))),
        rest(rest_shape(model, mesh, hierarchy_order(model))),
        humanoid(find_humanoid(model, rest.global)) {}

  PlacementContext context() const { return {model, mesh, rest, humanoid}; }
  int node(const std::string& humanoid_name) const { return humanoid.find(*humanoid_bone(humanoid_name)); }
  Vec3 place(const std::string& humanoid_name) const { return Vec3(rest.global[node(humanoid_name)][3]); }

  Model model;
  CharacterMesh mesh;
  RestShape rest;
  Humanoid humanoid;
};

}  // namespace sinew::test
