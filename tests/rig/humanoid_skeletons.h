#pragma once
/// Small human skeletons in every naming convention.

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "engine/core/text.h"
#include "engine/model/model.h"
#include "engine/rig/humanoid_bone.h"

namespace sinew::test {

using enum HumanoidBone;

/// How a convention calls a human's joints; '@' stands for the side. Empty: the skeleton has no such joint.
struct Convention {
  std::string label, left, right;
  std::string root, hips;
  std::vector<std::string> spine, neck;  ///< from below
  std::string head;
  std::string clavicle, upper_arm, lower_arm, hand;
  std::string upper_leg, lower_leg, foot, toes;
};

/// label; left, right; root; hips; spine from below; neck from below; head; clavicle; arm from above; leg from above;
/// toes
constexpr std::string_view convention_rows[] = {
    "VRM; left, right; Armature; hips; spine, chest, upperChest; neck; head; @Shoulder; @UpperArm, @LowerArm, @Hand; "
    "@UpperLeg, @LowerLeg, @Foot; @Toes",
    "Godot; Left, Right; Root; Hips; Spine, Chest, UpperChest; Neck; Head; @Shoulder; @UpperArm, @LowerArm, @Hand; "
    "@UpperLeg, @LowerLeg, @Foot; @Toes",
    "VRoid; L, R; Root; J_Bip_C_Hips; J_Bip_C_Spine, J_Bip_C_Chest; J_Bip_C_Neck; J_Bip_C_Head; J_Bip_@_Shoulder; "
    "J_Bip_@_UpperArm, J_Bip_@_LowerArm, J_Bip_@_Hand; J_Bip_@_UpperLeg, J_Bip_@_LowerLeg, J_Bip_@_Foot; "
    "J_Bip_@_ToeBase",
    "H-Anim 2, level 1; l, r; ; humanoid_root; vl5; ; skullbase; ; @_shoulder, @_elbow, @_radiocarpal; "
    "@_hip, @_knee, @_talocrural; @_metatarsophalangeal",
    "H-Anim 2, level 2; l, r; ; humanoid_root; vl5, vl3, vl1, vt10, vt6, vt1; vc4, vc2; skullbase; "
    "@_sternoclavicular; @_shoulder, @_elbow, @_radiocarpal; @_hip, @_knee, @_talocrural; @_metatarsophalangeal",
    "H-Anim 1; l, r; ; HumanoidRoot; vl5, vt4; vc4; skullbase; @_sternoclavicular; @_shoulder, @_elbow, @_wrist; "
    "@_hip, @_knee, @_ankle; @_midtarsal",
    "Mixamo; Left, Right; ; mixamorig:Hips; mixamorig:Spine, mixamorig:Spine1, mixamorig:Spine2; mixamorig:Neck; "
    "mixamorig:Head; mixamorig:@Shoulder; mixamorig:@Arm, mixamorig:@ForeArm, mixamorig:@Hand; "
    "mixamorig:@UpLeg, mixamorig:@Leg, mixamorig:@Foot; mixamorig:@ToeBase",
    "Mixamo in three.js; Left, Right; ; mixamorig1Hips; mixamorig1Spine, mixamorig1Spine1; mixamorig1Neck; "
    "mixamorig1Head; mixamorig1@Shoulder; mixamorig1@Arm, mixamorig1@ForeArm, mixamorig1@Hand; "
    "mixamorig1@UpLeg, mixamorig1@Leg, mixamorig1@Foot; mixamorig1@ToeBase",
    "Mixamo through an exporter; Left, Right; _rootJoint; mixamorig:Hips_01; mixamorig:Spine_02; mixamorig:Neck_05; "
    "mixamorig:Head_06; mixamorig:@Shoulder_07; mixamorig:@Arm_08, mixamorig:@ForeArm_09, mixamorig:@Hand_010; "
    "mixamorig:@UpLeg_055, mixamorig:@Leg_056, mixamorig:@Foot_057; mixamorig:@ToeBase_058",
    "MakeHuman default; L, R; ; root; spine05, spine04, spine03, spine02, spine01; neck01, neck02; head; clavicle.@; "
    "upperarm01.@, lowerarm01.@, wrist.@; upperleg01.@, lowerleg01.@, foot.@; toe1-1.@",
    "Unreal; l, r; root; pelvis; spine_01, spine_02, spine_03; neck_01; head; clavicle_@; "
    "upperarm_@, lowerarm_@, hand_@; thigh_@, calf_@, foot_@; ball_@",
    "Quaternius; L, R; Root; Hips; Abdomen, Torso, Chest; Neck; Head; Shoulder.@; UpperArm.@, LowerArm.@, Palm.@; "
    "UpperLeg.@, LowerLeg.@, Foot.@; ",
    "KayKit; l, r; root; hips; spine, chest; ; head; ; upperarm.@, lowerarm.@, hand.@; "
    "upperleg.@, lowerleg.@, foot.@; toes.@",
    "Rigify; L, R; root; DEF-spine; DEF-spine.001, DEF-spine.002, DEF-spine.003; DEF-spine.004, DEF-spine.005; "
    "DEF-spine.006; DEF-shoulder.@; DEF-upper_arm.@, DEF-forearm.@, DEF-hand.@; DEF-thigh.@, DEF-shin.@, DEF-foot.@; "
    "DEF-toe.@",
    "Blender metarig; L, R; metarig; spine; spine.001, spine.002, spine.003; spine.004, spine.005; spine.006; "
    "shoulder.@; upper_arm.@, forearm.@, hand.@; thigh.@, shin.@, foot.@; toe.@",
    "Biped; L, R; Bip01; Bip01 Pelvis; Bip01 Spine, Bip01 Spine1; Bip01 Neck; Bip01 Head; Bip01 @ Clavicle; "
    "Bip01 @ UpperArm, Bip01 @ Forearm, Bip01 @ Hand; Bip01 @ Thigh, Bip01 @ Calf, Bip01 @ Foot; Bip01 @ Toe0",
    "CMU BVH; Left, Right; ; Hips; LowerBack, Spine, Spine1; Neck, Neck1; Head; @Shoulder; @Arm, @ForeArm, @Hand; "
    "@UpLeg, @Leg, @Foot; @ToeBase",
    "CMU ASF; l, r; ; root; lowerback, upperback, thorax; lowerneck, upperneck; head; @clavicle; "
    "@humerus, @radius, @wrist; @femur, @tibia, @foot; @toes",
    "common BVH; Left, Right; ; Hips; Chest, Chest2, Chest3; Neck; Head; @Collar; @Shoulder, @Elbow, @Wrist; "
    "@Hip, @Knee, @Ankle; @Toe",
    "BVH without collars; Left, Right; ; Hips; Chest; Neck; Head; ; @Shoulder, @Elbow, @Wrist; @Hip, @Knee, @Ankle; ",
    "Poser; l, r; BODY; hip; abdomen, chest; neck; head; @Collar; @Shldr, @ForeArm, @Hand; @Thigh, @Shin, @Foot; @Toe",
    "Daz; l, r; Genesis8Male; hip; abdomenLower, abdomenUpper, chestLower, chestUpper; neckLower, neckUpper; head; "
    "@Collar; @ShldrBend, @ForearmBend, @Hand; @ThighBend, @Shin, @Foot; @Toe",
    "Reallusion; L, R; CC_Base_BoneRoot; CC_Base_Hip; CC_Base_Waist, CC_Base_Spine01; CC_Base_NeckTwist01; "
    "CC_Base_Head; CC_Base_@_Clavicle; CC_Base_@_Upperarm, CC_Base_@_Forearm, CC_Base_@_Hand; "
    "CC_Base_@_Thigh, CC_Base_@_Calf, CC_Base_@_Foot; CC_Base_@_ToeBase",
    "a leg that is the thigh; Left, Right; ; Pelvis; Spine; ; Head; ; @Arm, @Elbow, @Hand; @Leg, @Knee, @Foot; ",
};

inline std::vector<std::string> list_of(std::string_view text, char separator) {
  std::vector<std::string> items;
  for (const std::string& item : split(text, separator)) {
    const std::size_t start = item.find_first_not_of(' ');
    items.push_back(start == std::string::npos ? "" : item.substr(start));
  }
  return items.size() == 1 && items.front().empty() ? std::vector<std::string>() : items;
}

inline Convention parse_convention(std::string_view row) {
  const std::vector<std::string> fields = list_of(row, ';');
  const std::vector<std::string> sides = list_of(fields[1], ','), arm = list_of(fields[8], ','),
                                 leg = list_of(fields[9], ',');
  return {.label = fields[0],
          .left = sides[0],
          .right = sides[1],
          .root = fields[2],
          .hips = fields[3],
          .spine = list_of(fields[4], ','),
          .neck = list_of(fields[5], ','),
          .head = fields[6],
          .clavicle = fields[7],
          .upper_arm = arm[0],
          .lower_arm = arm[1],
          .hand = arm[2],
          .upper_leg = leg[0],
          .lower_leg = leg[1],
          .foot = leg[2],
          .toes = fields[10]};
}

inline std::vector<Convention> conventions() {
  std::vector<Convention> all;
  for (const std::string_view row : convention_rows) all.push_back(parse_convention(row));
  return all;
}

inline Convention convention(std::string_view label) {
  for (const std::string_view row : convention_rows)
    if (row.substr(0, row.find(';')) == label) return parse_convention(row);
  ADD_FAILURE() << "no convention " << label;
  return parse_convention(convention_rows[0]);
}

/// A model with the nodes that it should be recognised by.
struct Skeleton {
  Model model;
  std::map<HumanoidBone, std::string> expected;

  int add(const std::string& name, int parent, const Vec3& position) {
    Node node;
    node.name = name;
    node.parent = parent;
    node.rest.translation = position - (parent < 0 ? Vec3(0.0) : positions[parent]);
    model.nodes.push_back(node);
    positions.push_back(position);
    return static_cast<int>(positions.size()) - 1;
  }
  /// Adds the joint where the convention has one; otherwise its children hang from `parent`.
  int add_bone(HumanoidBone bone, const std::string& name, int parent, const Vec3& position) {
    if (name.empty()) return parent;
    expected[bone] = name;
    return add(name, parent, position);
  }

  std::vector<Vec3> positions;
};

inline std::string with_side(const std::string& pattern, const std::string& side) {
  const std::size_t at = pattern.find('@');
  return at == std::string::npos ? pattern : pattern.substr(0, at) + side + pattern.substr(at + 1);
}

inline void add_side(const Convention& convention, bool is_left, int pelvis, int chest, Skeleton& skeleton) {
  const std::string& side = is_left ? convention.left : convention.right;
  const double x = is_left ? 1.0 : -1.0;
  const auto bone = [&](HumanoidBone left) { return is_left ? left : mirrored_bone(left); };
  const auto name = [&](const std::string& pattern) { return with_side(pattern, side); };
  int joint = skeleton.add_bone(bone(left_shoulder), name(convention.clavicle), chest, {0.03 * x, 1.43, 0.0});
  joint = skeleton.add_bone(bone(left_upper_arm), name(convention.upper_arm), joint, {0.18 * x, 1.43, 0.0});
  joint = skeleton.add_bone(bone(left_lower_arm), name(convention.lower_arm), joint, {0.46 * x, 1.43, -0.01});
  skeleton.add_bone(bone(left_hand), name(convention.hand), joint, {0.72 * x, 1.43, 0.0});
  joint = skeleton.add_bone(bone(left_upper_leg), name(convention.upper_leg), pelvis, {0.1 * x, 0.93, 0.0});
  joint = skeleton.add_bone(bone(left_lower_leg), name(convention.lower_leg), joint, {0.1 * x, 0.5, 0.02});
  joint = skeleton.add_bone(bone(left_foot), name(convention.foot), joint, {0.1 * x, 0.08, -0.03});
  skeleton.add_bone(bone(left_toes), name(convention.toes), joint, {0.1 * x, 0.02, 0.12});
}

/// A T-pose that faces +Z, 1.6 m to the head.
inline Skeleton build(const Convention& convention) {
  Skeleton skeleton;
  int joint = convention.root.empty() ? -1 : skeleton.add(convention.root, -1, Vec3(0.0));
  const int pelvis = joint = skeleton.add_bone(hips, convention.hips, joint, {0, 0.95, 0});
  for (std::size_t i = 0; i < convention.spine.size(); ++i) {
    const double along = convention.spine.size() > 1 ? static_cast<double>(i) / (convention.spine.size() - 1.0) : 0.0;
    joint = skeleton.add(convention.spine[i], joint, {0, 1.05 + 0.25 * along, 0});
  }
  const int chest_joint = joint;
  skeleton.expected[spine] = convention.spine.front();
  for (std::size_t i = 0; i < convention.neck.size(); ++i)
    joint = skeleton.add(convention.neck[i], joint, {0, 1.48 + 0.04 * static_cast<double>(i), 0});
  if (!convention.neck.empty()) skeleton.expected[neck] = convention.neck.front();
  skeleton.add_bone(head, convention.head, joint, {0, 1.6, 0.02});
  for (const bool is_left : {true, false}) add_side(convention, is_left, pelvis, chest_joint, skeleton);
  return skeleton;
}

inline void link_children(Model& model) {
  for (Node& node : model.nodes) node.children.clear();
  model.roots.clear();
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const int parent = model.nodes[i].parent;
    (parent < 0 ? model.roots : model.nodes[parent].children).push_back(static_cast<int>(i));
  }
}

inline std::vector<Mat4> rest_transforms(const Model& model) {
  std::vector<Mat4> global(model.nodes.size());
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    global[i] = model.nodes[i].rest_local();
    for (int above = model.nodes[i].parent; above >= 0; above = model.nodes[above].parent)
      global[i] = model.nodes[above].rest_local() * global[i];
  }
  return global;
}

/// The same skeleton with its nodes in another order.
inline Model shuffled(const Model& model, unsigned seed) {
  std::vector<int> place(model.nodes.size());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), std::mt19937(seed));
  Model result = model;
  for (std::size_t i = 0; i < place.size(); ++i) {
    result.nodes[place[i]] = model.nodes[i];
    const int parent = model.nodes[i].parent;
    result.nodes[place[i]].parent = parent < 0 ? -1 : place[parent];
  }
  link_children(result);
  return result;
}

}  // namespace sinew::test
