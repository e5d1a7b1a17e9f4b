#pragma once
/// Forward kinematics: local transforms and morph weights to global transforms and the skin's palette.
/// engine/definitions.md 1.

#include <span>
#include <vector>

#include "engine/core/math.h"
#include "engine/model/character_mesh.h"
#include "engine/model/model.h"

namespace sinew {

/// Where every node of a model stands, and how far every morph target is in.
struct Pose {
  std::vector<Transform> local;                    ///< [nodes]
  std::vector<std::vector<double>> morph_weights;  ///< [nodes][targets of the node's mesh]
};

/// The file's own rest pose.
Pose rest_pose(const Model& model);

/// Global transforms of all nodes, [nodes]: C_root = L_root, C_i = C_parent L_i. `order` is hierarchy_order(model).
std::vector<Mat4> global_transforms(const Model& model, std::span<const int> order, const Pose& pose);

/// Global rotation of every node in the rest pose, [nodes]: the product of the local rotations, scales left out.
std::vector<Quat> rest_rotations(const Model& model, std::span<const int> order);

/// Sets a node to its rest rotation turned by `degrees` about the model's x, y, z axes (x first), whatever the joint's
/// own axes are: the new local rotation is W^-1 R W q (scenes/README.md, "Joint keys").
void turn_joint(const Model& model, std::span<const Quat> rest_rotations, int node, const Vec3& degrees, Pose& pose);

/// Turns a node further from where the pose has it, about the same axes: the new local rotation is W^-1 R W p.
void turn_joint_further(const Model& model, std::span<const Quat> rest_rotations, int node, const Vec3& degrees,
                        Pose& pose);

/// Goes from one pose towards another, weight 0 to 1: rotations by slerp the shorter way, the rest in proportion.
/// Both are of the same model.
void blend_pose(const Pose& towards, double weight, Pose& pose);

/// Final transforms F_i = C_i B_i of a mesh's palette, [palette], moved by `placement` (model to world).
std::vector<Mat34> palette_transforms(const CharacterMesh& mesh, std::span<const Mat4> global,
                                      const Mat4& placement = Mat4(1.0));

/// The pose's weights in the order of the mesh's morph slots, [morph_slots].
std::vector<double> morph_slot_weights(const CharacterMesh& mesh, const Pose& pose);

}  // namespace sinew
