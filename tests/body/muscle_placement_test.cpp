#include "engine/body/muscle_placement.h"

#include <gtest/gtest.h>

#include "tests/body/fleshed_skeleton.h"
#include "tests/support/test_character.h"

namespace sinew::test {
namespace {

/// Roundings of positions of a few metres.
constexpr double rounding = 1e-12;

class Placement : public testing::Test {
 protected:
  static MuscleSpec preset(MusclePreset preset, MuscleSide side = MuscleSide::left) {
    MuscleSpec spec;
    spec.preset = preset;
    spec.side = side;
    return spec;
  }
  static PlacedMuscle placed(const Fleshed& body, const MuscleSpec& spec) {
    auto result = place_muscle(body.context(), spec);
    if (result) return *result;
    ADD_FAILURE() << result.error().message;
    return {};
  }
  static void expect_refused(const Fleshed& body, const MuscleSpec& spec, std::initializer_list<const char*> parts) {
    const auto result = place_muscle(body.context(), spec);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::bad_input);
    for (const char* part : parts)
      EXPECT_NE(result.error().message.find(part), std::string::npos) << result.error().message;
  }

  const Fleshed body{arms_of({})};
};

TEST_F(Placement, APresetsNumbersAreInUnitsOfTheLimb) {
  struct Case {
    MusclePreset preset;
    double from, to, spread, peak_radii, along_lengths, across_radii, reference_angle, radius;
    const char *bone, *child, *tip;
  };
  // engine/definitions.md 7
  for (const Case& c :
       {Case{MusclePreset::biceps, 1.0 / 3.0, 1.0, 75, 0.30, 0.20, 0.70, 35, arm_radius, "UpperArm", "LowerArm",
             "Hand"},
        Case{MusclePreset::calf, 0.05, 0.60, 60, 0.12, 0.15, 0.70, 150, leg_radius, "LowerLeg", "Foot", "Toes"}})
    for (const MuscleSide side : {MuscleSide::left, MuscleSide::right}) {
      const PlacedMuscle got = placed(body, preset(c.preset, side));
      const std::string word = side == MuscleSide::left ? "left" : "right";
      const Muscle& m = got.muscle;
      EXPECT_EQ(m.name, (c.preset == MusclePreset::biceps ? "biceps_" : "calf_") + word);
      EXPECT_EQ(m.bone, body.node(word + c.bone));
      EXPECT_EQ(m.child, body.node(word + c.child));
      EXPECT_EQ(m.driver, m.child);
      EXPECT_EQ(m.tip, body.node(word + c.tip));
      EXPECT_EQ(m.from, c.from);
      EXPECT_EQ(m.to, c.to);
      EXPECT_EQ(m.spread, c.spread);
      EXPECT_EQ(m.reference_angle, c.reference_angle);
      const double length = glm::distance(body.place(word + c.bone), body.place(word + c.child));
      EXPECT_NEAR(m.peak, c.peak_radii * c.radius, rounding);
      EXPECT_NEAR(m.sigma.x, c.along_lengths * length, rounding);
      EXPECT_NEAR(m.sigma.y, c.across_radii * c.radius, rounding);
      EXPECT_NEAR(got.region.plane.length, length, rounding);
      EXPECT_EQ(m.rest_angle, got.driver.degrees(body.rest.global));
      EXPECT_EQ(got.driver.at, m.driver);
      EXPECT_GT(got.region.vertices.size(), 20u);
    }
}

TEST_F(Placement, AStraightArmsBicepsFacesTheFrontAndACalfTheBack) {
  EXPECT_LT(glm::distance(placed(body, preset(MusclePreset::biceps)).muscle.facing, Vec3(0, 0, 1)), rounding);
  for (const MuscleSide side : {MuscleSide::left, MuscleSide::right})
    EXPECT_LT(glm::distance(placed(body, preset(MusclePreset::calf, side)).muscle.facing, Vec3(0, 0, -1)), rounding);
}

TEST_F(Placement, ABentArmShowsItsFlexorSideByItself) {
  for (const auto& [hand, facing] : {std::pair(Vec3(0.6, 1.60, 0.0), Vec3(0, 1, 0)),
                                     {Vec3(0.6, 1.30, 0.0), Vec3(0, -1, 0)},
                                     {Vec3(0.6, 1.43, 0.2), Vec3(0, 0, 1)},
                                     {Vec3(0.6, 1.43, -0.2), Vec3(0, 0, -1)}}) {
    const Fleshed bent(arms_of({.elbow = {0.46, 1.43, 0}, .hand = hand}));
    for (const MuscleSide side : {MuscleSide::left, MuscleSide::right})
      EXPECT_LT(glm::distance(placed(bent, preset(MusclePreset::biceps, side)).region.plane.normal, facing), rounding);
  }
}

TEST_F(Placement, FiveDegreesOfBendTell) {
  // Bent upwards by a little less and a little more: the front first, then the inside of the bend.
  for (const auto& [degrees, facing] : {std::pair(4.9, Vec3(0, 0, 1)), {5.1, Vec3(0, 1, 0)}}) {
    const double bend = degrees * degrees_to_radians;
    const Vec3 hand = Vec3(0.46, 1.43, 0) + 0.26 * Vec3(std::cos(bend), std::sin(bend), 0);
    const Fleshed bent(arms_of({.elbow = {0.46, 1.43, 0}, .hand = hand}));
    const PlacedMuscle biceps = placed(bent, preset(MusclePreset::biceps));
    EXPECT_NEAR(biceps.muscle.rest_angle, 180 - degrees, 1e-9);
    EXPECT_LT(glm::distance(biceps.region.plane.normal, facing), rounding) << degrees;
  }
}

TEST_F(Placement, TheBodysFrontTurnsWithTheBody) {
  for (const double turn : {90.0, 180.0, -35.0}) {
    Model model = arms_of({});
    model.nodes[0].rest.rotation = rotation_xyz_degrees({0, turn, 0});
    const Fleshed turned(model);
    const Vec3 front = rotation_xyz_degrees({0, turn, 0}) * Vec3(0, 0, 1);
    EXPECT_LT(glm::distance(placed(turned, preset(MusclePreset::biceps)).muscle.facing, front), rounding);
    const PlacedMuscle calf = placed(turned, preset(MusclePreset::calf)),
                       before = placed(body, preset(MusclePreset::calf));
    EXPECT_LT(glm::distance(calf.muscle.facing, -front), rounding);
    EXPECT_EQ(calf.region.vertices.size(), before.region.vertices.size());
    EXPECT_NEAR(calf.muscle.peak, before.muscle.peak, rounding);
  }
}

TEST_F(Placement, LeftAndRightAreMirrored) {
  for (const MusclePreset which : {MusclePreset::biceps, MusclePreset::calf}) {
    const PlacedMuscle left = placed(body, preset(which, MuscleSide::left)),
                       right = placed(body, preset(which, MuscleSide::right));
    EXPECT_LT(glm::distance(left.region.centre, right.region.centre * Vec3(-1, 1, 1)), rounding);
    EXPECT_EQ(left.region.vertices.size(), right.region.vertices.size());
    EXPECT_NEAR(left.muscle.peak, right.muscle.peak, rounding);
    EXPECT_NEAR(left.muscle.rest_angle, right.muscle.rest_angle, rounding);
  }
}

TEST_F(Placement, EveryExplicitKeyOverridesThePreset) {
  MuscleSpec spec = preset(MusclePreset::biceps);
  spec.name = "mine";
  spec.bone = "leftLowerArm";
  spec.child = "leftHand";
  spec.driver = "leftLowerArm";
  spec.tip = "leftHand";
  spec.facing = Vec3(0, 2, 0);
  spec.from = 0.1;
  spec.to = 0.7;
  spec.spread = 33;
  spec.peak = 0.5;
  spec.sigma = Vec2(0.25, 0.125);
  spec.rest_angle = 160;
  spec.reference_angle = 20;
  const Muscle m = placed(body, spec).muscle;
  EXPECT_EQ(m.name, "mine");
  EXPECT_EQ(m.bone, body.node("leftLowerArm"));
  EXPECT_EQ(m.child, body.node("leftHand"));
  EXPECT_EQ(m.driver, body.node("leftLowerArm"));
  EXPECT_EQ(m.tip, body.node("leftHand"));
  EXPECT_EQ(m.facing, Vec3(0, 2, 0));
  EXPECT_EQ(m.from, 0.1);
  EXPECT_EQ(m.to, 0.7);
  EXPECT_EQ(m.spread, 33);
  EXPECT_EQ(m.peak, 0.5);
  EXPECT_EQ(m.sigma, Vec2(0.25, 0.125));
  EXPECT_EQ(m.rest_angle, 160);
  EXPECT_EQ(m.reference_angle, 20);
  // One key alone leaves the rest as it was.
  MuscleSpec lower = preset(MusclePreset::biceps);
  lower.peak = -0.01;
  EXPECT_EQ(placed(body, lower).muscle.peak, -0.01);
  EXPECT_EQ(placed(body, lower).muscle.sigma, placed(body, preset(MusclePreset::biceps)).muscle.sigma);
}

TEST_F(Placement, ThePresetsDriverFollowsAnotherChild) {
  MuscleSpec spec = preset(MusclePreset::biceps);
  spec.child = "leftHand";
  spec.tip = "head";  // the hand has no joint after it
  EXPECT_EQ(placed(body, spec).muscle.driver, body.node("leftHand"));
}

TEST_F(Placement, OnlyTheBendAtTheBonesOwnEndTellsTheFlexorSide) {
  const Fleshed bent(arms_of({.elbow = {0.46, 1.43, 0}, .hand = {0.6, 1.60, 0.0}}));
  MuscleSpec spec = preset(MusclePreset::biceps);
  spec.driver = "rightLowerArm";
  EXPECT_LT(glm::distance(placed(bent, spec).region.plane.normal, Vec3(0, 0, 1)), rounding);
}

MuscleSpec stated_muscle() {
  MuscleSpec spec;
  spec.name = "shin";
  spec.bone = "leftLowerLeg";
  spec.child = "leftFoot";
  spec.facing = Vec3(0, 0, 1);
  spec.from = 0.2;
  spec.to = 0.8;
  spec.spread = 50.0;
  spec.peak = 0.01;
  spec.sigma = Vec2(0.1, 0.05);
  spec.reference_angle = 60;
  return spec;
}

TEST_F(Placement, AMuscleWithoutAPresetIsAsItIsStated) {
  const PlacedMuscle shin = placed(body, stated_muscle());
  EXPECT_EQ(shin.muscle.driver, body.node("leftFoot")) << "the child drives it unless another joint is named";
  EXPECT_EQ(shin.muscle.tip, body.node("leftToes"));
  EXPECT_EQ(shin.muscle.rest_angle, shin.driver.degrees(body.rest.global)) << "measured on the rest pose";
  EXPECT_EQ(shin.muscle.peak, 0.01);
  EXPECT_EQ(shin.muscle.sigma, Vec2(0.1, 0.05));
}

TEST_F(Placement, WhatCannotBePlacedSaysWhy) {
  MuscleSpec spec = stated_muscle();
  spec.bone = "leftLowerLeh";
  expect_refused(body, spec, {"muscle \"shin\"", "\"leftLowerLeh\"", "leftLowerLeg"});
  for (const auto field : {&MuscleSpec::child, &MuscleSpec::driver, &MuscleSpec::tip}) {
    spec = stated_muscle();
    spec.*field = "tentacle";
    expect_refused(body, spec, {"muscle \"shin\"", "\"tentacle\""});
  }
  spec = stated_muscle();
  spec.driver = "leftToes";
  expect_refused(body, spec, {"muscle \"shin\"", "no angle", "leftToes"});
  spec = stated_muscle();
  spec.rest_angle = spec.reference_angle;
  expect_refused(body, spec, {"muscle \"shin\"", "60", "must differ"});
  spec = stated_muscle();
  std::swap(spec.from, spec.to);
  expect_refused(body, spec, {"muscle \"shin\"", "0.8", "0.2", "from must be less than to"});
  spec.from = spec.to;
  expect_refused(body, spec, {"from must be less than to"});
  spec = stated_muscle();
  spec.facing = body.place("leftFoot") - body.place("leftLowerLeg");
  expect_refused(body, spec, {"muscle \"shin\"", "runs along the limb"});
  spec = stated_muscle();
  spec.child = "leftLowerLeg";
  expect_refused(body, spec, {"muscle \"shin\"", "same place"});
}

TEST_F(Placement, ALimbWithoutVerticesIsNoFailure) {
  const Fleshed bare(build(convention("VRM")).model);
  const PlacedMuscle biceps = placed(bare, preset(MusclePreset::biceps));
  EXPECT_TRUE(biceps.region.vertices.empty());
  EXPECT_EQ(biceps.muscle.peak, 0.0);
  EXPECT_GT(biceps.muscle.sigma.y, 0.0) << "heights divide by it";
}

TEST_F(Placement, AWholeHumanoidHasFourMusclesByDefault) {
  std::vector<std::string> problems, names;
  for (const PlacedMuscle& placed : default_muscles(body.context(), problems)) names.push_back(placed.muscle.name);
  EXPECT_EQ(names, (std::vector<std::string>{"biceps_left", "biceps_right", "calf_left", "calf_right"}));
  EXPECT_TRUE(problems.empty());
}

TEST_F(Placement, ACalfWithoutToesIsDrivenByTheKneeAndSaysSo) {
  // Without toes and without anything below the foot the ankle has no angle.
  const Fleshed footless(fleshed(build(convention("Quaternius")).model));
  std::vector<std::string> problems;
  const std::vector<PlacedMuscle> muscles = default_muscles(footless.context(), problems);
  ASSERT_EQ(muscles.size(), 4u);
  EXPECT_TRUE(problems.empty());
  for (const std::size_t calf : {2u, 3u}) {
    EXPECT_EQ(muscles[calf].muscle.driver, muscles[calf].muscle.bone);
    EXPECT_EQ(muscles[calf].muscle.reference_angle, 60.0) << "of the knee, not of the ankle";
    ASSERT_EQ(placement_problems(muscles[calf]).size(), 1u);
    EXPECT_NE(placement_problems(muscles[calf])[0].find("LowerLeg drives"), std::string::npos);
  }
  EXPECT_TRUE(placement_problems(muscles[0]).empty());
}

TEST_F(Placement, ADriverWithoutAnAngleIsRefused) {
  const Fleshed footless(fleshed(build(convention("Quaternius")).model));
  MuscleSpec spec = preset(MusclePreset::calf);
  spec.driver = "leftFoot";
  expect_refused(footless, spec, {"\"calf_left\"", "no angle can be measured"});
}

TEST_F(Placement, WhatIsNoHumanoidOrHasNoSkinHasNone) {
  std::vector<std::string> problems;
  const Fleshed bare(build(convention("VRM")).model);
  EXPECT_TRUE(default_muscles(bare.context(), problems).empty());
  Fleshed headless(arms_of({}));
  headless.humanoid.node[index_of(HumanoidBone::head)] = -1;
  EXPECT_TRUE(default_muscles(headless.context(), problems).empty());
  EXPECT_TRUE(problems.empty());
}

}  // namespace
}  // namespace sinew::test
