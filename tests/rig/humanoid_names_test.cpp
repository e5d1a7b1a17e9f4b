#include "engine/rig/humanoid_names.h"

#include <set>

#include <gtest/gtest.h>

#include "engine/rig/humanoid_bone.h"

namespace sinew {
namespace {

using enum HumanoidBone;

TEST(HumanoidBones, NamesGoThereAndBack) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < humanoid_bone_count; ++i) {
    const auto bone = static_cast<HumanoidBone>(i);
    names.insert(humanoid_name(bone));
    EXPECT_EQ(humanoid_bone(humanoid_name(bone)), bone);
    EXPECT_EQ(mirrored_bone(mirrored_bone(bone)), bone);
    EXPECT_EQ(is_required(mirrored_bone(bone)), is_required(bone));
  }
  EXPECT_EQ(names.size(), humanoid_bone_count);
  EXPECT_EQ(humanoid_name(left_upper_arm), "leftUpperArm");
  EXPECT_EQ(mirrored_bone(left_upper_arm), right_upper_arm);
  EXPECT_EQ(mirrored_bone(jaw), jaw);
  EXPECT_FALSE(humanoid_bone("LeftUpperArm"));
  EXPECT_FALSE(humanoid_bone(""));
}

TEST(HumanoidBones, FifteenAreRequired) {
  int required = 0;
  for (std::size_t i = 0; i < humanoid_bone_count; ++i) required += is_required(static_cast<HumanoidBone>(i)) ? 1 : 0;
  EXPECT_EQ(required, 15);
  EXPECT_FALSE(is_required(neck));
  EXPECT_FALSE(is_required(left_toes));
  EXPECT_FALSE(is_required(left_shoulder));
}

TEST(HumanoidBones, ChainsAndParents) {
  EXPECT_EQ(next_on_chain(hips), spine);
  EXPECT_EQ(next_on_chain(upper_chest), neck);
  EXPECT_EQ(next_on_chain(head), std::nullopt);
  EXPECT_EQ(next_on_chain(right_shoulder), right_upper_arm);
  EXPECT_EQ(next_on_chain(left_lower_arm), left_hand);
  EXPECT_EQ(next_on_chain(left_hand), left_middle_proximal);
  EXPECT_EQ(next_on_chain(right_foot), right_toes);
  EXPECT_EQ(next_on_chain(right_toes), std::nullopt);
  EXPECT_EQ(next_on_chain(left_thumb_distal), std::nullopt);
  EXPECT_EQ(parent_bone(hips), std::nullopt);
  EXPECT_EQ(parent_bone(left_upper_arm), left_shoulder);
  EXPECT_EQ(parent_bone(left_upper_leg), hips);
  EXPECT_EQ(parent_bone(right_little_proximal), right_hand);
}

struct Example {
  const char* name;
  BodyPart part;
  Side side;
  int ordinal = 0;
};

TEST(HumanoidNames, KnownSpellings) {
  const Example examples[] = {{"leftUpperArm", BodyPart::upper_arm, Side::left},
                              {"LeftUpperArm", BodyPart::upper_arm, Side::left},
                              {"Left upper arm", BodyPart::upper_arm, Side::left},
                              {"l_shoulder", BodyPart::clavicle_or_upper_arm, Side::left},
                              {"r_talocrural", BodyPart::foot, Side::right},
                              {"l_eyeball_joint", BodyPart::eye, Side::left},
                              {"vl5", BodyPart::spine, Side::middle},
                              {"vc4", BodyPart::neck, Side::middle},
                              {"temporomandibular", BodyPart::jaw, Side::middle},
                              {"l_carpometacarpal_1", BodyPart::thumb, Side::left, 1},
                              {"l_metacarpophalangeal_2", BodyPart::index, Side::left, 1},
                              {"r_carpal_distal_interphalangeal_5", BodyPart::little, Side::right, 3},
                              {"mixamorig:LeftForeArm", BodyPart::lower_arm, Side::left},
                              {"mixamorigLeftHandThumb1", BodyPart::thumb, Side::left, 1},
                              {"mixamorig7:Spine2", BodyPart::spine, Side::middle},
                              {"Armature|mixamorig:Hips", BodyPart::hips, Side::middle},
                              {"upperarm01.L", BodyPart::upper_arm, Side::left},
                              {"finger2-3.R", BodyPart::index, Side::right, 3},
                              {"index_01_l", BodyPart::index, Side::left, 1},
                              {"thigh_r", BodyPart::upper_leg, Side::right},
                              {"DEF-upper_arm.L", BodyPart::upper_arm, Side::left},
                              {"DEF-f_index.01.L", BodyPart::index, Side::left, 1},
                              {"DEF-spine.003", BodyPart::spine, Side::middle},
                              {"Bip01 L UpperArm", BodyPart::upper_arm, Side::left},
                              {"Bip001 R Finger0", BodyPart::thumb, Side::right, 1},
                              {"Bip001 R Finger01", BodyPart::thumb, Side::right, 2},
                              {"Bip001 R Finger1", BodyPart::index, Side::right, 1},
                              {"Bip001 R Finger12", BodyPart::index, Side::right, 3},
                              {"ValveBiped.Bip01_R_Calf", BodyPart::lower_leg, Side::right},
                              {"CC_Base_L_Upperarm", BodyPart::upper_arm, Side::left},
                              {"CC_Base_NeckTwist01", BodyPart::neck, Side::middle},
                              {"J_Bip_C_UpperChest", BodyPart::spine, Side::middle},
                              {"J_Bip_R_LowerLeg", BodyPart::lower_leg, Side::right},
                              {"lfemur", BodyPart::upper_leg, Side::left},
                              {"rradius", BodyPart::lower_arm, Side::right},
                              {"lowerback", BodyPart::spine, Side::middle},
                              {"lowerneck", BodyPart::neck, Side::middle},
                              {"lShldrBend", BodyPart::upper_arm, Side::left},
                              {"b_LeftHand_011", BodyPart::hand, Side::left},
                              {"Hand.L.001", BodyPart::hand, Side::left},
                              {"LeftIndexProximal", BodyPart::index, Side::left, 1},
                              {"Spine", BodyPart::spine, Side::middle},
                              {"root", BodyPart::hips, Side::middle}};
  for (const Example& example : examples) {
    const auto reading = read_joint_name(example.name);
    ASSERT_TRUE(reading) << example.name;
    EXPECT_EQ(reading->part, example.part) << example.name;
    EXPECT_EQ(reading->side, example.side) << example.name;
    EXPECT_EQ(reading->ordinal, example.ordinal) << example.name;
  }
}

TEST(HumanoidNames, HelpersAreNothing) {
  for (const char* name : {"",
                           "...",
                           "42",
                           "kneeIK.l",
                           "control-foot-roll.l",
                           "handIK.l",
                           "heelIK.l",
                           "IK-foot.l",
                           "handslot.l",
                           "Head_end",
                           "HeadTop_End",
                           "head_leaf",
                           "Hand.L_end",
                           "index_04_leaf_l",
                           "LeftHandIndex4_Nub",
                           "upperarm_twist_01_l",
                           "lShldrTwist",
                           "LeftArmRoll",
                           "foot_target.L",
                           "elbow_pole.R",
                           "upperarm02.L",
                           "finger6-1.L",
                           "breast.L",
                           "Left_Right_Hand",
                           "MCH-hand.L",
                           "J_Sec_Hair1",
                           "EndSite",
                           "Armature",
                           "LeftHandHumanoid"})
    EXPECT_FALSE(read_joint_name(name)) << name;
}

TEST(HumanoidNames, SurerNamesHaveLessDoubt) {
  const auto doubt = [](const char* name) { return read_joint_name(name)->doubt; };
  EXPECT_LT(doubt("hand.l"), doubt("wrist.l"));
  EXPECT_LT(doubt("DEF-hand.L"), doubt("ORG-hand.L"));
  EXPECT_LT(doubt("DEF-thigh.L"), doubt("DEF-thigh.L.001"));
  EXPECT_LT(doubt("pelvis"), doubt("root"));
}

}  // namespace
}  // namespace sinew
