#include "engine/view/clip_editor.h"

#include <gtest/gtest.h>

#include "tests/view/made_up_clip.h"

namespace sinew::test {
namespace {

constexpr CurveChoice left_arm_z{3, 2};

TEST(ClipEditor, ShowsWhatTheFitLeft) {
  ClipEditor editor(made_up_clip("wave", true));
  for (std::size_t joint = 0; joint < 5; ++joint)
    for (int axis = 0; axis < 3; ++axis) {
      const ClipEditor::Residual& residual = editor.residual({joint, axis});
      EXPECT_LE(residual.largest, 0.2 + 1e-9) << joint << " " << axis;
      EXPECT_LE(residual.rms, residual.largest + 1e-12);
      EXPECT_EQ(residual.values.size(), editor.times().size());
    }
  EXPECT_EQ(editor.samples(left_arm_z).size(), editor.times().size());
  EXPECT_FALSE(editor.is_edited());
}

TEST(ClipEditor, ADragIsOneEditAndIsTakenBack) {
  ClipEditor editor(made_up_clip("wave", true));
  const std::vector<double> before = sampled(editor.curve(left_arm_z));
  const std::size_t key = editor.curve(left_arm_z).segments() / 2;
  for (int i = 1; i <= 10; ++i) ASSERT_TRUE(editor.set_key(left_arm_z, key, 2.0 * i));
  EXPECT_EQ(editor.edits().size(), 1u);
  EXPECT_NEAR(curve_keys(editor.curve(left_arm_z))[key].value, 20.0, 1e-9);
  editor.seal();
  ASSERT_TRUE(editor.set_key(left_arm_z, key, 25.0));
  EXPECT_EQ(editor.edits().size(), 2u) << "another drag";
  editor.take_back();
  EXPECT_NEAR(curve_keys(editor.curve(left_arm_z))[key].value, 20.0, 1e-9);
  editor.take_back();
  EXPECT_EQ(sampled(editor.curve(left_arm_z)), before) << "to the bit";
  EXPECT_FALSE(editor.is_edited());
}

TEST(ClipEditor, ASlopeThatWasDraggedStaysWhileItsValueIs) {
  ClipEditor editor(made_up_clip("wave", true));
  const std::size_t key = 1;
  const double value = curve_keys(editor.curve(left_arm_z))[key].value;
  ASSERT_TRUE(editor.set_key(left_arm_z, key, value, 33.0));
  ASSERT_TRUE(editor.set_key(left_arm_z, key, value + 4.0));
  EXPECT_NEAR(curve_keys(editor.curve(left_arm_z))[key].slope, 33.0, 1e-6);
  EXPECT_NEAR(curve_keys(editor.curve(left_arm_z))[key].value, value + 4.0, 1e-9);
}

TEST(ClipEditor, WhatIsShownIsWhatTheLibraryMakesOfTheEdits) {
  const StoredClip parent = made_up_clip("wave", true);
  ClipEditor editor(parent);
  ASSERT_TRUE(editor.add_key(left_arm_z, 1.01));
  ASSERT_TRUE(editor.set_key(left_arm_z, 1, 12.0));
  ASSERT_TRUE(editor.set_key({4, 0}, 0, -5.0, 10.0));
  EditedMotion replayed{parent.motion.skeleton, *parent.curves};
  ASSERT_TRUE(apply_edits(replayed, editor.edits(), {}));
  EXPECT_EQ(sampled(editor.curve(left_arm_z)), sampled(replayed.curves.joints[3].angles[2]));
  EXPECT_EQ(sampled(editor.curve({4, 0})), sampled(replayed.curves.joints[4].angles[0]));
}

TEST(ClipEditor, AnEditThatFailsChangesNothing) {
  ClipEditor editor(made_up_clip("wave", true));
  const std::vector<double> before = sampled(editor.curve(left_arm_z));
  EXPECT_FALSE(editor.add_key(left_arm_z, 99.0)) << "beyond the end";
  EXPECT_FALSE(editor.is_edited());
  EXPECT_EQ(sampled(editor.curve(left_arm_z)), before);
}

TEST(ClipEditor, AKeyIsDraggedInTimeBetweenItsNeighbours) {
  const StoredClip parent = made_up_clip("wave", true);
  ClipEditor editor(parent);
  const std::vector<double> before = sampled(editor.curve(left_arm_z));
  for (const double seconds : {1.0, 2.0}) ASSERT_TRUE(editor.add_key(left_arm_z, seconds));
  const std::vector<double> cuts = editor.curve(left_arm_z).cuts;
  const double frame = parent.motion.frame_time;
  for (const double to : {cuts[1] + 2.0 * frame, 1e6, cuts[1] + frame})
    ASSERT_TRUE(editor.set_key(left_arm_z, 1, 15.0, {}, to));
  EXPECT_NEAR(editor.curve(left_arm_z).cuts[1], cuts[1] + frame, 1e-9) << "where it was let go, from where it was";
  EXPECT_NEAR(curve_keys(editor.curve(left_arm_z))[1].value, 15.0, 1e-9);
  EditedMotion replayed{parent.motion.skeleton, *parent.curves};
  ASSERT_TRUE(apply_edits(replayed, editor.edits(), {}));
  EXPECT_EQ(sampled(editor.curve(left_arm_z)), sampled(replayed.curves.joints[3].angles[2]));
  editor.seal();
  ASSERT_TRUE(editor.set_key(left_arm_z, 1, 15.0, {}, 1e6));
  EXPECT_NEAR(editor.curve(left_arm_z).cuts[1], cuts[2] - frame, 1e-9) << "a frame before its neighbour";
  ASSERT_TRUE(editor.set_key(left_arm_z, 0, 15.0, {}, 0.5));
  EXPECT_EQ(editor.curve(left_arm_z).cuts[0], cuts[0]) << "ends stay";
  for (int i = 0; i < 5; ++i) editor.take_back();
  EXPECT_FALSE(editor.is_edited()) << "each drag is one step";
  EXPECT_EQ(sampled(editor.curve(left_arm_z)), before) << "to the bit";
}

TEST(ClipEditor, TheResidualFollowsTheCurve) {
  ClipEditor editor(made_up_clip("wave", true));
  const double before = editor.residual(left_arm_z).largest;
  const std::size_t key = editor.curve(left_arm_z).segments() / 2;
  ASSERT_TRUE(editor.set_key(left_arm_z, key, curve_keys(editor.curve(left_arm_z))[key].value + 30.0));
  EXPECT_GT(editor.residual(left_arm_z).largest, before + 25.0);
  editor.take_back();
  EXPECT_EQ(editor.residual(left_arm_z).largest, before);
}

}  // namespace
}  // namespace sinew::test
