/// The humanoid joints of real characters.

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/io/gltf_read.h"
#include "engine/rig/humanoid.h"
#include "tests/rig/humanoid_skeletons.h"
#include "tests/support/assets.h"

namespace sinew {
namespace {

using enum HumanoidBone;

struct Character {
  Model model;
  std::vector<Mat4> global;
  Humanoid humanoid;

  std::string name_of(HumanoidBone bone) const {
    const int node = humanoid.find(bone);
    return node < 0 ? "" : model.nodes[node].name;
  }
  Vec3 position(HumanoidBone bone) const { return Vec3(global[humanoid.find(bone)][3]); }
  std::string notes() const {
    std::string all;
    for (const std::string& note : humanoid.notes) all += note + "\n";
    return all;
  }
};

Character read(const std::filesystem::path& file) {
  auto model = read_gltf(file);
  if (!model) {
    ADD_FAILURE() << model.error().message;
    return {};
  }
  Character character{.model = std::move(*model), .global = {}, .humanoid = {}};
  character.global = test::rest_transforms(character.model);
  character.humanoid = find_humanoid(character.model, character.global);
  return character;
}

/// Reading takes far longer than what is tested: each file is read once.
const Character& load(const std::filesystem::path& file) {
  static std::map<std::filesystem::path, Character> characters;
  const auto known = characters.find(file);
  return known != characters.end() ? known->second : characters.emplace(file, read(file)).first->second;
}

const std::vector<std::string> humanoids = {"characters/makehuman/mh_male_default.glb",
                                            "characters/makehuman/mh_male_game.glb",
                                            "characters/mesh2motion/human-male.glb",
                                            "characters/mesh2motion/human-sintel.glb",
                                            "characters/mesh2motion/human-zombie.glb",
                                            "characters/mesh2motion/rig-human.glb",
                                            "bad/mesh2motion/m2m-wrong-bone-names.glb",
                                            "characters/kaykit/Knight.glb",
                                            "characters/quaternius/modular_men_Casual.glb",
                                            "characters/quaternius/modular_men_King.glb",
                                            "characters/quaternius/modular_men_Suit.glb",
                                            "characters/quaternius/modular_men_Worker.glb",
                                            "characters/quaternius/modular_women_Casual.glb",
                                            "characters/quaternius/modular_women_Formal.glb",
                                            "characters/quaternius/modular_women_Soldier.glb",
                                            "characters/quaternius/cyberpunk_Character.glb",
                                            "characters/khronos/CesiumMan.glb",
                                            "characters/khronos/CesiumMan_named.gltf"};

TEST(HumanoidCharacters, HumansAreComplete) {
  SINEW_ASSETS_OR_SKIP(assets);
  for (const std::string& file : humanoids) {
    const Character& character = load(assets / file);
    EXPECT_TRUE(character.humanoid.complete()) << file << "\n" << character.notes();
  }
}

TEST(HumanoidCharacters, OthersAreNot) {
  SINEW_ASSETS_OR_SKIP(assets);
  for (const char* file :
       {"khronos/Fox.glb", "quaternius/alien/Alien_Scolitex.gltf", "godot_hand/LeftHandHumanoid.gltf",
        "khronos/RiggedSimple.glb", "khronos/SimpleSkin.gltf", "khronos/AnimatedMorphCube.glb"}) {
    const Character& character = load(assets / "characters" / file);
    EXPECT_FALSE(character.humanoid.complete()) << file;
  }
}

TEST(HumanoidCharacters, LeftIsLeftAndFrontIsWhereToesPoint) {
  SINEW_ASSETS_OR_SKIP(assets);
  for (const std::string& file : humanoids) {
    SCOPED_TRACE(file);
    const Character& character = load(assets / file);
    if (!character.humanoid.complete()) continue;
    const Vec3 left = body_left(character.model, character.humanoid, character.global);
    const Vec3 up = body_up(character.model, character.humanoid, character.global);
    const Vec3 front = body_front(character.model, character.humanoid, character.global);
    EXPECT_NEAR(glm::length(glm::cross(left, up) - front), 0.0, 1e-12);
    for (std::size_t i = 0; i < humanoid_bone_count; ++i) {
      const auto bone = static_cast<HumanoidBone>(i);
      const HumanoidBone right = mirrored_bone(bone);
      if (index_of(right) <= i || character.humanoid.find(bone) < 0 || character.humanoid.find(right) < 0) continue;
      EXPECT_GT(glm::dot(character.position(bone) - character.position(right), left), 0.0) << humanoid_name(bone);
    }
    if (character.humanoid.find(left_toes) < 0 || character.humanoid.find(right_toes) < 0) continue;
    Vec3 toes = character.position(left_toes) - character.position(left_foot) + character.position(right_toes) -
                character.position(right_foot);
    toes -= glm::dot(toes, up) * up;
    EXPECT_LT(angle_degrees(toes, front), 40.0);
  }
}

TEST(HumanoidCharacters, FacesWhereItsFileFaces) {
  SINEW_ASSETS_OR_SKIP(assets);
  for (const std::string& file : humanoids) {
    const Character& character = load(assets / file);
    // All of them face +Z but the older CesiumMan, whose axes are turned.
    const Vec3 expected = file.ends_with("CesiumMan.glb") ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
    EXPECT_LT(angle_degrees(body_front(character.model, character.humanoid, character.global), expected), 25.0) << file;
    EXPECT_LT(angle_degrees(body_up(character.model, character.humanoid, character.global), Vec3(0, 1, 0)), 15.0)
        << file;
  }
}

void expect_names(const Character& character, const std::map<HumanoidBone, std::string>& expected) {
  for (const auto& [bone, name] : expected) EXPECT_EQ(character.name_of(bone), name) << humanoid_name(bone);
}

TEST(HumanoidCharacters, MakeHumanDefault) {
  SINEW_ASSETS_OR_SKIP(assets);
  const Character& character = load(assets / "characters/makehuman/mh_male_default.glb");
  expect_names(character, {{hips, "root"},
                           {spine, "spine05"},
                           {chest, "spine03"},
                           {upper_chest, "spine01"},
                           {neck, "neck01"},
                           {head, "head"},
                           {jaw, "jaw"},
                           {left_eye, "eye.L"},
                           {left_shoulder, "clavicle.L"},
                           {left_upper_arm, "upperarm01.L"},
                           {left_lower_arm, "lowerarm01.L"},
                           {left_hand, "wrist.L"},
                           {left_thumb_metacarpal, "finger1-1.L"},
                           {left_little_distal, "finger5-3.L"},
                           {right_upper_leg, "upperleg01.R"},
                           {right_lower_leg, "lowerleg01.R"},
                           {right_foot, "foot.R"},
                           {right_toes, "toe1-1.R"}});
}

TEST(HumanoidCharacters, GameEngineNames) {
  SINEW_ASSETS_OR_SKIP(assets);
  const Character& character = load(assets / "characters/makehuman/mh_male_game.glb");
  expect_names(character, {{hips, "pelvis"},
                           {spine, "spine_01"},
                           {chest, "spine_02"},
                           {upper_chest, "spine_03"},
                           {neck, "neck_01"},
                           {left_shoulder, "clavicle_l"},
                           {left_hand, "hand_l"},
                           {left_lower_leg, "calf_l"},
                           {left_toes, "ball_l"},
                           {right_thumb_distal, "thumb_03_r"},
                           {right_index_proximal, "index_01_r"}});
  EXPECT_TRUE(character.humanoid.notes.empty()) << character.notes();
}

TEST(HumanoidCharacters, RigifyNames) {
  SINEW_ASSETS_OR_SKIP(assets);
  expect_names(load(assets / "bad/mesh2motion/m2m-wrong-bone-names.glb"), {{hips, "DEF-hips"},
                                                                           {upper_chest, "DEF-spine.003"},
                                                                           {head, "DEF-head"},
                                                                           {left_lower_arm, "DEF-forearm.L"},
                                                                           {left_index_proximal, "DEF-f_index01.L"},
                                                                           {left_thumb_distal, "DEF-thumb03.L"},
                                                                           {left_toes, "DEF-toe.L"}});
}

TEST(HumanoidCharacters, KayKitHandIsTheHandAndControlsAreNothing) {
  SINEW_ASSETS_OR_SKIP(assets);
  expect_names(load(assets / "characters/kaykit/Knight.glb"), {{hips, "hips"},
                                                               {chest, "chest"},
                                                               {left_upper_arm, "upperarm.l"},
                                                               {left_hand, "hand.l"},
                                                               {left_foot, "foot.l"},
                                                               {left_toes, "toes.l"},
                                                               {head, "head"}});
}

TEST(HumanoidCharacters, QuaterniusFingersCountedFromTwo) {
  SINEW_ASSETS_OR_SKIP(assets);
  expect_names(load(assets / "characters/quaternius/modular_men_King.glb"), {{hips, "Hips"},
                                                                             {spine, "Abdomen"},
                                                                             {upper_chest, "Chest"},
                                                                             {left_shoulder, "Shoulder.L"},
                                                                             {left_upper_arm, "UpperArm.L"},
                                                                             {left_index_proximal, "Index2.L"},
                                                                             {left_index_distal, "Index4.L"},
                                                                             {left_thumb_metacarpal, ""},
                                                                             {left_thumb_proximal, "Thumb2.L"},
                                                                             {left_thumb_distal, "Thumb3.L"}});
}

TEST(HumanoidCharacters, FeetOfAnIkRigAreFoundByTheirPlace) {
  SINEW_ASSETS_OR_SKIP(assets);
  const Character& character = load(assets / "characters/quaternius/cyberpunk_Character.glb");
  expect_names(character, {{left_foot, "Foot.L"}, {right_foot, "Foot.R"}, {right_hand, "Hand.R"}, {hips, "Hips"}});
  EXPECT_NE(character.notes().find("\"Foot.L\" does not hang from \"LowerLeg.L\""), std::string::npos);
}

TEST(HumanoidCharacters, CesiumManIsFoundByShapeTheSameWithAndWithoutNames) {
  SINEW_ASSETS_OR_SKIP(assets);
  const Character& unnamed = load(assets / "characters/khronos/CesiumMan.glb");
  const Character& named = load(assets / "characters/khronos/CesiumMan_named.gltf");
  EXPECT_NE(unnamed.notes().find("found by shape"), std::string::npos);
  EXPECT_NE(named.notes().find("found by shape"), std::string::npos);
  expect_names(named, {{hips, "Skeleton_torso_joint_1"},
                       {spine, "Skeleton_torso_joint_2"},
                       {chest, "torso_joint_3"},
                       {neck, "Skeleton_neck_joint_1"},
                       {head, "Skeleton_neck_joint_2"},
                       {left_upper_arm, "Skeleton_arm_joint_L__4_"},
                       {left_lower_arm, "Skeleton_arm_joint_L__3_"},
                       {left_hand, "Skeleton_arm_joint_L__2_"},
                       {right_upper_arm, "Skeleton_arm_joint_R"},
                       {left_upper_leg, "leg_joint_L_1"},
                       {left_foot, "leg_joint_L_3"},
                       {right_toes, "leg_joint_R_5"}});
  // The later export stands a quarter turn about y from the first.
  for (std::size_t i = 0; i < humanoid_bone_count; ++i) {
    const auto bone = static_cast<HumanoidBone>(i);
    ASSERT_EQ(unnamed.humanoid.find(bone) < 0, named.humanoid.find(bone) < 0) << humanoid_name(bone);
    if (named.humanoid.find(bone) < 0) continue;
    const Vec3 a = unnamed.position(bone), b = named.position(bone);
    EXPECT_LT(glm::length(Vec3(-a.z, a.y, a.x) - b), 0.05) << humanoid_name(bone);
  }
}

TEST(HumanoidCharacters, FoxStandsOnFourLegs) {
  SINEW_ASSETS_OR_SKIP(assets);
  const Character& fox = load(assets / "characters/khronos/Fox.glb");
  EXPECT_NE(fox.notes().find("stands on four legs"), std::string::npos) << fox.notes();
  EXPECT_EQ(fox.humanoid.find(left_upper_arm), -1);
}

TEST(HumanoidCharacters, HandAloneHasItsFingers) {
  SINEW_ASSETS_OR_SKIP(assets);
  expect_names(load(assets / "characters/godot_hand/LeftHandHumanoid.gltf"),
               {{left_hand, "LeftHand"},
                {left_lower_arm, ""},
                {left_thumb_metacarpal, "LeftThumbMetacarpal"},
                {left_thumb_distal, "LeftThumbDistal"},
                {left_index_proximal, "LeftIndexProximal"},
                {left_little_distal, "LeftLittleDistal"}});
}

}  // namespace
}  // namespace sinew
