/// The humanoid joints of small skeletons in every naming convention.

#include "engine/rig/humanoid.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/rig/humanoid_skeletons.h"

namespace sinew {
namespace {

using enum HumanoidBone;
using namespace test;

std::string notes_of(const Humanoid& humanoid) {
  std::string all;
  for (const std::string& note : humanoid.notes) all += note + "\n";
  return all;
}

std::string found_name(const Model& model, const Humanoid& humanoid, HumanoidBone bone) {
  const int node = humanoid.find(bone);
  return node < 0 ? "(absent)" : model.nodes[node].name;
}

void expect_found(const Model& model, const Humanoid& humanoid, const std::map<HumanoidBone, std::string>& expected) {
  EXPECT_TRUE(humanoid.complete()) << notes_of(humanoid);
  for (const auto& [bone, name] : expected)
    EXPECT_EQ(found_name(model, humanoid, bone), name) << humanoid_name(bone) << "\n" << notes_of(humanoid);
}

void remove_names(Model& model) {
  for (Node& node : model.nodes) node.name.clear();
}

TEST(Humanoid, EveryConvention) {
  for (const Convention& convention : conventions()) {
    SCOPED_TRACE(convention.label);
    Skeleton skeleton = build(convention);
    link_children(skeleton.model);
    expect_found(skeleton.model, find_humanoid(skeleton.model, rest_transforms(skeleton.model)), skeleton.expected);
  }
}

TEST(Humanoid, AnyOrderOfNodes) {
  for (const Convention& convention : conventions())
    for (const unsigned seed : {1u, 2u, 3u}) {
      SCOPED_TRACE(convention.label);
      const Skeleton skeleton = build(convention);
      const Model model = shuffled(skeleton.model, seed);
      expect_found(model, find_humanoid(model, rest_transforms(model)), skeleton.expected);
    }
}

TEST(Humanoid, TurnedLyingAndScaled) {
  const Vec3 turns[] = {{0, 90, 0}, {0, 180, 0}, {-90, 0, 0}, {0, 0, 90}, {180, 0, 0}, {30, 40, 50}};
  for (const Convention& convention : conventions())
    for (const Vec3& turn : turns)
      for (const double scale : {1.0, 100.0, 0.01}) {
        SCOPED_TRACE(convention.label);
        Skeleton skeleton = build(convention);
        link_children(skeleton.model);
        const Transform placement{{5, 6, 7}, rotation_xyz_degrees(turn), Vec3(scale)};
        std::vector<Mat4> global = rest_transforms(skeleton.model);
        for (Mat4& transform : global) transform = placement.matrix() * transform;
        const Humanoid humanoid = find_humanoid(skeleton.model, global);
        expect_found(skeleton.model, humanoid, skeleton.expected);
        const auto turned = [&](const Vec3& v) { return placement.rotation * v; };
        EXPECT_LT(angle_degrees(body_up(skeleton.model, humanoid, global), turned({0, 1, 0})), 5.0);
        EXPECT_LT(angle_degrees(body_left(skeleton.model, humanoid, global), turned({1, 0, 0})), 1e-3);
        EXPECT_LT(angle_degrees(body_front(skeleton.model, humanoid, global), turned({0, 0, 1})), 5.0);
      }
}

TEST(Humanoid, ViewersSidesAreExchanged) {
  Convention viewers = convention("Unreal");
  std::swap(viewers.left, viewers.right);
  Skeleton skeleton = build(viewers);
  link_children(skeleton.model);
  const auto global = rest_transforms(skeleton.model);
  const Humanoid humanoid = find_humanoid(skeleton.model, global);
  EXPECT_EQ(found_name(skeleton.model, humanoid, left_lower_arm), "lowerarm_r");
  EXPECT_NEAR(body_front(skeleton.model, humanoid, global).z, 1.0, 0.01);
  EXPECT_NE(notes_of(humanoid).find("were exchanged"), std::string::npos);
}

TEST(Humanoid, ArmsNamedAgainstTheLegsFollowThem) {
  Convention arms_exchanged = convention("Unreal");
  Skeleton skeleton = build(arms_exchanged);
  for (Node& node : skeleton.model.nodes)
    if (node.name.find("arm_") != std::string::npos || node.name.starts_with("hand") ||
        node.name.starts_with("clavicle"))
      node.name.back() = node.name.back() == 'l' ? 'r' : 'l';
  link_children(skeleton.model);
  const Humanoid humanoid = find_humanoid(skeleton.model, rest_transforms(skeleton.model));
  EXPECT_EQ(found_name(skeleton.model, humanoid, left_hand), "hand_r");
  EXPECT_EQ(found_name(skeleton.model, humanoid, left_foot), "foot_l");
}

TEST(Humanoid, ShoulderOverElbowIsTheUpperArmAndIsNoted) {
  Skeleton skeleton = build(convention("BVH without collars"));
  link_children(skeleton.model);
  const Humanoid humanoid = find_humanoid(skeleton.model, rest_transforms(skeleton.model));
  EXPECT_NE(notes_of(humanoid).find("\"LeftShoulder\" is the upper arm"), std::string::npos);
  EXPECT_EQ(humanoid.find(left_shoulder), -1);
}

TEST(Humanoid, ShapeAloneSufficesForAPlainSkeleton) {
  for (const char* label : {"VRM", "Unreal", "KayKit", "Blender metarig"}) {
    SCOPED_TRACE(label);
    Skeleton skeleton = build(convention(label));
    const std::map<HumanoidBone, std::string> expected = skeleton.expected;
    link_children(skeleton.model);
    Model unnamed = skeleton.model;
    remove_names(unnamed);
    const Humanoid humanoid = find_humanoid(unnamed, rest_transforms(unnamed));
    EXPECT_TRUE(humanoid.complete());
    EXPECT_NE(notes_of(humanoid).find("found by shape"), std::string::npos);
    for (const HumanoidBone bone :
         {hips, left_upper_arm, left_hand, right_lower_arm, left_upper_leg, right_foot, spine})
      EXPECT_EQ(found_name(skeleton.model, humanoid, bone), expected.at(bone)) << humanoid_name(bone);
  }
}

TEST(Humanoid, ShapeAloneRefusesASecondPairOfArms) {
  Skeleton skeleton = build(convention("KayKit"));
  const auto chest_joint = std::find_if(skeleton.model.nodes.begin(), skeleton.model.nodes.end(),
                                        [](const Node& node) { return node.name == "chest"; });
  for (const double x : {1.0, -1.0}) {
    int joint = static_cast<int>(chest_joint - skeleton.model.nodes.begin());
    for (const double reach : {0.18, 0.46, 0.72}) joint = skeleton.add("", joint, {reach * x, 1.2, 0});
  }
  link_children(skeleton.model);
  remove_names(skeleton.model);
  EXPECT_FALSE(find_humanoid(skeleton.model, rest_transforms(skeleton.model)).complete());
}

TEST(Humanoid, FourLegsAreNoHumanoidWhateverTheirNames) {
  Skeleton skeleton;
  const int pelvis = skeleton.add("Hips", -1, {0, 0.6, -0.5});
  const int chest_joint = skeleton.add("Spine", pelvis, {0, 0.65, 0});
  const int throat = skeleton.add("Neck", chest_joint, {0, 0.7, 0.5});
  skeleton.add("Head", throat, {0, 0.8, 0.7});
  for (const auto& [side, x] : {std::pair<std::string, double>{"Left", 0.1}, {"Right", -0.1}}) {
    int joint = skeleton.add(side + "UpLeg", pelvis, {x, 0.55, -0.5});
    joint = skeleton.add(side + "Leg", joint, {x, 0.3, -0.45});
    skeleton.add(side + "Foot", joint, {x, 0.05, -0.5});
    joint = skeleton.add(side + "Arm", chest_joint, {x, 0.55, 0.4});
    joint = skeleton.add(side + "ForeArm", joint, {x, 0.3, 0.38});
    skeleton.add(side + "Hand", joint, {x, 0.1, 0.4});
  }
  link_children(skeleton.model);
  const Humanoid humanoid = find_humanoid(skeleton.model, rest_transforms(skeleton.model));
  EXPECT_FALSE(humanoid.complete());
  EXPECT_EQ(humanoid.find(left_hand), -1);
  EXPECT_NE(notes_of(humanoid).find("four legs"), std::string::npos);
}

TEST(Humanoid, TheFilesOwnMapGoesFirst) {
  Skeleton skeleton = build(convention("Mixamo"));
  link_children(skeleton.model);
  const auto global = rest_transforms(skeleton.model);
  Model& model = skeleton.model;
  const Humanoid named = find_humanoid(model, global);
  for (std::size_t i = 0; i < humanoid_bone_count; ++i) {
    const auto bone = static_cast<HumanoidBone>(i);
    if (is_required(bone)) model.vrm_bones[std::string(humanoid_name(bone))] = named.find(mirrored_bone(bone));
  }
  const Humanoid mapped = find_humanoid(model, global);
  EXPECT_EQ(found_name(model, mapped, left_hand), "mixamorig:RightHand");
  EXPECT_EQ(mapped.find(neck), -1) << "a whole map is the whole truth";

  model.vrm_bones = {
      {"leftHand", named.find(left_hand)}, {"rightHand", named.find(left_hand)}, {"tail", 0}, {"jaw", 999}};
  const Humanoid filled = find_humanoid(model, global);
  EXPECT_TRUE(filled.complete()) << notes_of(filled);
  EXPECT_EQ(filled.find(jaw), -1);
  EXPECT_NE(notes_of(filled).find("\"tail\" is left out: no such humanoid bone"), std::string::npos);
  EXPECT_NE(notes_of(filled).find("\"jaw\" is left out: no such node"), std::string::npos);
  EXPECT_NE(notes_of(filled).find("\"rightHand\" is left out"), std::string::npos);
}

TEST(Humanoid, PresentNeighboursPassOverAbsentBones) {
  Skeleton skeleton = build(convention("KayKit"));
  link_children(skeleton.model);
  const Humanoid humanoid = find_humanoid(skeleton.model, rest_transforms(skeleton.model));
  EXPECT_EQ(humanoid.next_present(chest), head);
  EXPECT_EQ(humanoid.parent_present(left_upper_arm), chest);
  EXPECT_EQ(humanoid.next_present(left_hand), std::nullopt);
  EXPECT_EQ(humanoid.parent_present(hips), std::nullopt);
}

TEST(Humanoid, EmptyModelHasNoneAndStandardDirections) {
  const Model model;
  const Humanoid humanoid = find_humanoid(model, {});
  EXPECT_FALSE(humanoid.complete());
  EXPECT_EQ(humanoid.missing_required().size(), 15u);
  EXPECT_TRUE(humanoid.notes.empty());
  EXPECT_EQ(body_up(model, humanoid, {}), Vec3(0, 1, 0));
  EXPECT_EQ(body_left(model, humanoid, {}), Vec3(1, 0, 0));
  EXPECT_EQ(body_front(model, humanoid, {}), Vec3(0, 0, 1));
}

TEST(FindJoint, NodeNameFirstThenHumanoidName) {
  Skeleton skeleton = build(convention("Unreal"));
  skeleton.model.file = "man.glb";
  skeleton.add("leftHand", 0, Vec3(0.0));
  link_children(skeleton.model);
  const Humanoid humanoid = find_humanoid(skeleton.model, rest_transforms(skeleton.model));
  EXPECT_EQ(find_joint(skeleton.model, humanoid, "leftHand").value(),
            static_cast<int>(skeleton.model.nodes.size()) - 1);
  EXPECT_EQ(find_joint(skeleton.model, humanoid, "leftLowerArm").value(), humanoid.find(left_lower_arm));
  EXPECT_EQ(find_joint(skeleton.model, humanoid, "lowerarm_l").value(), humanoid.find(left_lower_arm));
}

TEST(FindJoint, UnknownNamesSayWhatIsNearest) {
  Skeleton skeleton = build(convention("Unreal"));
  skeleton.model.file = "man.glb";
  link_children(skeleton.model);
  const Humanoid humanoid = find_humanoid(skeleton.model, rest_transforms(skeleton.model));
  const auto mistyped = find_joint(skeleton.model, humanoid, "leftLoverArm");
  ASSERT_FALSE(mistyped);
  EXPECT_EQ(mistyped.error().kind, ErrorKind::bad_input);
  EXPECT_NE(mistyped.error().message.find("man.glb"), std::string::npos);
  EXPECT_NE(mistyped.error().message.find("did you mean \"leftLowerArm\""), std::string::npos);
  const auto absent = find_joint(skeleton.model, humanoid, "jaw");
  ASSERT_FALSE(absent);
  EXPECT_NE(absent.error().message.find("jaw"), std::string::npos);
  EXPECT_FALSE(find_joint(skeleton.model, humanoid, ""));
}

}  // namespace
}  // namespace sinew
