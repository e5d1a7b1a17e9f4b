#include "engine/rig/humanoid.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/core/text.h"
#include "engine/rig/humanoid_search.h"
#include "engine/rig/humanoid_shape.h"
#include "engine/rig/joint_tree.h"

namespace sinew {
namespace {

using enum HumanoidBone;

bool in_use(const Humanoid& humanoid, int node) {
  return std::find(humanoid.node.begin(), humanoid.node.end(), node) != humanoid.node.end();
}

/// The bones that the file itself names.
Humanoid read_vrm_map(const Model& model) {
  Humanoid humanoid;
  for (const auto& [name, node] : model.vrm_bones) {
    const auto bone = humanoid_bone(name);
    if (!bone || node < 0 || node >= static_cast<int>(model.nodes.size()))
      humanoid.notes.push_back(
          fmt::format("the file's VRM map: \"{}\" is left out: no such {}", name, bone ? "node" : "humanoid bone"));
    else if (in_use(humanoid, node))
      humanoid.notes.push_back(
          fmt::format("the file's VRM map: \"{}\" is left out: {} is another bone already", name, called(model, node)));
    else
      humanoid.node[index_of(*bone)] = node;
  }
  return humanoid;
}

/// Takes over the bones that are still absent, and whose node is still free.
void fill_gaps(const BoneNodes& bones, Humanoid& humanoid) {
  for (std::size_t i = 0; i < bones.size(); ++i)
    if (humanoid.node[i] < 0 && bones[i] >= 0 && !in_use(humanoid, bones[i])) humanoid.node[i] = bones[i];
}

std::vector<std::string> names_of(std::span<const HumanoidBone> bones) {
  std::vector<std::string> names;
  for (const HumanoidBone bone : bones) names.emplace_back(humanoid_name(bone));
  return names;
}

/// Left and right are the character's own. Arms that contradict the legs follow them; then, where toes and
/// knees point backwards, the names were the viewer's and all are exchanged.
void correct_sides(const JointTree& tree, Humanoid& humanoid) {
  const auto across = [&](HumanoidBone left) {
    const int l = humanoid.find(left), r = humanoid.find(mirrored_bone(left));
    return l < 0 || r < 0 ? Vec3(0.0) : tree.position(l) - tree.position(r);
  };
  if (glm::dot(across(left_upper_arm), across(left_upper_leg)) < 0.0) {
    swap_sides(humanoid.node, left_shoulder);
    humanoid.notes.push_back("the arms' left and right were exchanged: their names contradict the legs'");
  }
  // Toes alone make a third of a leg's length; 0.15 is beyond what standing knees and unlike feet can do.
  const BodyAxes axes = body_axes(tree, humanoid.node);
  if (facing_evidence(tree, humanoid.node, axes.up, axes.front) >= -0.15 * leg_length(tree, humanoid.node)) return;
  swap_sides(humanoid.node);
  humanoid.notes.push_back("the names' left and right were exchanged: toes and knees point to the body's front");
}

/// The first required bone on which names and shape disagree. Spine and hips may be split differently.
std::optional<HumanoidBone> contradiction(const Humanoid& named, const BoneNodes& shape) {
  for (std::size_t i = 0; i < humanoid_bone_count; ++i) {
    const auto bone = static_cast<HumanoidBone>(i);
    if (!is_required(bone) || bone == hips || bone == spine || named.node[i] < 0) continue;
    if (shape[i] != named.node[i]) return bone;
  }
  return std::nullopt;
}

/// The last resort where names leave gaps.
void complete_by_shape(const Model& model, const JointTree& tree, Humanoid& humanoid) {
  const auto shape = find_by_shape(tree);
  if (!shape) return;
  if (shape->four_legs) {
    humanoid.node.fill(-1);
    humanoid.notes.push_back("no humanoid: it stands on four legs");
    return;
  }
  if (const auto bone = contradiction(humanoid, shape->bones)) {
    humanoid.notes.push_back(fmt::format("the shape takes {} for {}, the names {}: the shape is not followed",
                                         called(model, shape->bones[index_of(*bone)]), humanoid_name(*bone),
                                         called(model, humanoid.find(*bone))));
    return;
  }
  humanoid.notes.push_back(fmt::format("found by shape: {}", fmt::join(names_of(humanoid.missing_required()), ", ")));
  BoneNodes named = humanoid.node;
  for (const HumanoidBone bone : {hips, spine, chest, upper_chest, neck, left_shoulder, right_shoulder})
    named[index_of(bone)] = -1;
  humanoid.node = shape->bones;
  fill_gaps(named, humanoid);
}

void note_missing(Humanoid& humanoid) {
  const std::vector<HumanoidBone> missing = humanoid.missing_required();
  const bool none_found = std::all_of(humanoid.node.begin(), humanoid.node.end(), [](int node) { return node < 0; });
  if (!missing.empty() && !none_found)
    humanoid.notes.push_back(fmt::format("not a whole humanoid: no {}", fmt::join(names_of(missing), ", ")));
}

BodyAxes axes_of(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global) {
  return body_axes(JointTree(model, rest_global), humanoid.node);
}

}  // namespace

std::vector<HumanoidBone> Humanoid::missing_required() const {
  std::vector<HumanoidBone> missing;
  for (std::size_t i = 0; i < node.size(); ++i)
    if (const auto bone = static_cast<HumanoidBone>(i); is_required(bone) && node[i] < 0) missing.push_back(bone);
  return missing;
}

std::optional<HumanoidBone> Humanoid::next_present(HumanoidBone bone) const {
  auto next = next_on_chain(bone);
  while (next && find(*next) < 0) next = next_on_chain(*next);
  return next;
}

std::optional<HumanoidBone> Humanoid::parent_present(HumanoidBone bone) const {
  auto parent = parent_bone(bone);
  while (parent && find(*parent) < 0) parent = parent_bone(*parent);
  return parent;
}

Humanoid find_humanoid(const Model& model, std::span<const Mat4> rest_global) {
  Humanoid humanoid = read_vrm_map(model);
  if (humanoid.complete()) return humanoid;
  const bool mapped = !model.vrm_bones.empty();
  const JointTree tree(model, rest_global);
  fill_gaps(find_by_names(model, tree, humanoid.notes), humanoid);
  if (!mapped) correct_sides(tree, humanoid);
  if (!humanoid.complete()) complete_by_shape(model, tree, humanoid);
  if (stands_on_four_legs(tree, humanoid.node)) {
    humanoid.node.fill(-1);
    humanoid.notes.push_back("no humanoid: it stands on four legs");
  }
  note_missing(humanoid);
  return humanoid;
}

Vec3 body_up(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global) {
  return axes_of(model, humanoid, rest_global).up;
}

Vec3 body_left(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global) {
  return axes_of(model, humanoid, rest_global).left;
}

Vec3 body_front(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global) {
  return axes_of(model, humanoid, rest_global).front;
}

Result<int> find_joint(const Model& model, const Humanoid& humanoid, std::string_view name) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    if (!name.empty() && model.nodes[i].name == name) return static_cast<int>(i);
    if (!model.nodes[i].name.empty()) known.push_back(model.nodes[i].name);
  }
  const auto bone = humanoid_bone(name);
  if (bone && humanoid.find(*bone) >= 0) return humanoid.find(*bone);
  for (std::size_t i = 0; i < humanoid_bone_count; ++i)
    if (humanoid.node[i] >= 0) known.emplace_back(humanoid_name(static_cast<HumanoidBone>(i)));
  // A skeleton may come from no file.
  const std::string of = model.file.empty() ? "" : model.file + ": ";
  if (bone)
    return bad_input("{}no joint of this model is the humanoid bone \"{}\"; `sinew info` lists the bones it has", of,
                     name);
  return bad_input("{}no joint \"{}\"{}: give a node's name, or a VRM humanoid name such as \"leftLowerArm\"", of, name,
                   did_you_mean(name, known));
}

}  // namespace sinew
