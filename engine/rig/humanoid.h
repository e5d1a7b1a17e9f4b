#pragma once
/// The humanoid joints of any model: VRM 1.0 bones found in the file's own map, by names, or by the skeleton's shape.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/math.h"
#include "engine/core/result.h"
#include "engine/model/model.h"
#include "engine/rig/humanoid_bone.h"

namespace sinew {

struct Humanoid {
  BoneNodes node;                  ///< which node each bone is; -1: absent
  std::vector<std::string> notes;  ///< what was decided against a first look at the names, for people

  Humanoid() { node.fill(-1); }

  /// The bone's node, or -1.
  int find(HumanoidBone bone) const { return node[index_of(bone)]; }
  /// True where all of the 15 bones that VRM requires were found.
  bool complete() const { return missing_required().empty(); }
  std::vector<HumanoidBone> missing_required() const;
  /// The next bone on the chain, or before it in the hierarchy, that this model has; absent ones are passed over.
  std::optional<HumanoidBone> next_present(HumanoidBone bone) const;
  std::optional<HumanoidBone> parent_present(HumanoidBone bone) const;
};

/// The humanoid of a model. The file's own VRM map is believed where it is complete; else names fill its gaps, each
/// candidate checked against hierarchy and rest pose (engine/definitions.md 8); where names do not suffice, the shape
/// alone decides if it leaves no choice. What stands on four legs has no humanoid bones at all. `rest_global`: [nodes]
/// global transforms of the rest pose.
Humanoid find_humanoid(const Model& model, std::span<const Mat4> rest_global);

/// Unit directions of the body in the rest pose, measured from the joints, whichever way the model stands, faces or
/// lies: up from the hips to the neck or head, left from the right to the left hips and shoulders at right angles to
/// up, front = cross(left, up). Without joints to measure: +Y, +X, +Z. `rest_global`: [nodes] global rest transforms.
Vec3 body_up(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global);
Vec3 body_left(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global);
Vec3 body_front(const Model& model, const Humanoid& humanoid, std::span<const Mat4> rest_global);

/// The node of a joint called by its node's name (letter by letter, first such node) or else by its humanoid name.
/// Fails as bad_input with the nearest known name.
Result<int> find_joint(const Model& model, const Humanoid& humanoid, std::string_view name);

}  // namespace sinew
