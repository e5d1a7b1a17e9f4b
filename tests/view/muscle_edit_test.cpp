#include "engine/view/muscle_edit.h"

#include "engine/model/scene_words.h"
#include "tests/view/opened_document.h"

namespace sinew::test {
namespace {

TEST(MuscleEdit, AnglesStayApart) {
  Muscle placed;
  placed.rest_angle = 170.0;
  placed.reference_angle = 40.0;
  const auto set = [&](MuscleAngle which, double degrees) {
    MuscleSpec spec;
    set_muscle_angle(spec, placed, which, degrees);
    EXPECT_NE(spec.rest_angle.has_value(), spec.reference_angle.has_value()) << "only the one that was asked for";
    return which == MuscleAngle::rest ? *spec.rest_angle : *spec.reference_angle;
  };
  EXPECT_EQ(set(MuscleAngle::rest, 150.0), 150.0);
  EXPECT_EQ(set(MuscleAngle::rest, 40.0), 41.0);
  EXPECT_EQ(set(MuscleAngle::rest, 39.5), 39.0);
  EXPECT_EQ(set(MuscleAngle::reference, 500.0), 180.0);
  EXPECT_EQ(set(MuscleAngle::reference, -5.0), 0.0);
  placed.rest_angle = 180.0;
  EXPECT_EQ(set(MuscleAngle::reference, 180.0), 179.0) << "nothing is beyond a straight joint";
  placed.reference_angle = 0.0;
  EXPECT_EQ(set(MuscleAngle::rest, 0.0), 1.0);
}

TEST(MuscleEdit, APresetComesWithItsNumbers) {
  Document document = opened("builtin:woman");
  const StagedCharacter& staged = document.stage().characters[0];
  Scene scene = document.scene();
  Character& character = scene.characters[0];
  EXPECT_TRUE(has_muscle(character, MusclePreset::biceps, MuscleSide::left));
  EXPECT_FALSE(has_muscle(character, MusclePreset::triceps, MuscleSide::right));
  ASSERT_TRUE(add_muscle(character, staged, MusclePreset::triceps, MuscleSide::right));
  ASSERT_EQ(character.muscles.size(), 5u);
  const MuscleSpec& added = character.muscles.back();
  EXPECT_FALSE(added.preset);
  EXPECT_TRUE(added.peak && added.sigma && added.rest_angle && added.reference_angle);
  EXPECT_TRUE(has_muscle(character, MusclePreset::triceps, MuscleSide::right));
  EXPECT_TRUE(document.edit(scene, "add"));
}

TEST(MuscleEdit, AllThatFitComeOnce) {
  Document document = opened("builtin:woman");
  Scene scene = document.scene();
  scene.characters[0].muscles[0].peak = 0.123;
  ASSERT_TRUE(document.edit(scene, "peak"));
  const auto added = add_fitting_muscles(scene.characters[0], document.stage().characters[0]);
  ASSERT_TRUE(added) << added.error().message;
  EXPECT_EQ(*added, 12) << "all eight on both sides, less the four that a bare figure has";
  EXPECT_EQ(scene.characters[0].muscles[0].peak, 0.123) << "those that are there stay";
  ASSERT_TRUE(document.edit(scene, "add"));
  EXPECT_EQ(*add_fitting_muscles(scene.characters[0], document.stage().characters[0]), 0);
  scene.characters[0].muscles.clear();
  EXPECT_EQ(*add_fitting_muscles(scene.characters[0], document.stage().characters[0]), 16);
}

TEST(MuscleEdit, AModelWithoutTheJointsSaysSo) {
  Document document = opened("builtin:head");
  Scene scene = document.scene();
  const Scene before = scene;
  const StagedCharacter& staged = document.stage().characters[0];
  const auto one = add_muscle(scene.characters[0], staged, MusclePreset::calf, MuscleSide::left);
  ASSERT_FALSE(one);
  EXPECT_NE(one.error().message.find("leftLowerLeg"), std::string::npos) << one.error().message;
  const auto all = add_fitting_muscles(scene.characters[0], staged);
  ASSERT_FALSE(all);
  EXPECT_NE(all.error().message.find("no place for any muscle"), std::string::npos) << all.error().message;
  EXPECT_EQ(scene, before);
}

}  // namespace
}  // namespace sinew::test
