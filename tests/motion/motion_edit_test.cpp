#include "engine/motion/motion_edit.h"

#include <gtest/gtest.h>

#include "engine/motion/key_edit.h"
#include "engine/motion/motion_fit.h"
#include "tests/motion/made_up_motion.h"

namespace sinew {
namespace {

using Json = nlohmann::json;

class MotionEdit : public testing::Test {
 protected:
  MotionEdit() {
    CurveFitOptions options;
    options.tolerance = 0.05;
    const Motion motion = test::made_up_motion("wave");
    edited = {motion.skeleton, fit_motion(motion, options).clip};
    before = edited;
  }

  Result<void> apply(const Json& edit) {
    return apply_edits(edited, Json::array({edit}), [&](const std::string& name) -> Result<EditedMotion> {
      if (name != "other") return bad_input("no clip \"{}\"", name);
      CurveFitOptions options;
      options.tolerance = 0.05;
      const Motion other = test::made_up_motion("other", 60, 0.5);
      return EditedMotion{other.skeleton, fit_motion(other, options).clip};
    });
  }

  const PiecewisePolynomial& head() const { return edited.curves.joints[2].angles[0]; }
  const PiecewisePolynomial& head_before() const { return before.curves.joints[2].angles[0]; }
  MotionFrame frame(double seconds) const {
    MotionFrame frame;
    sample_curves(edited.curves, edited.skeleton, seconds, frame);
    return frame;
  }
  MotionFrame frame_before(double seconds) const {
    MotionFrame frame;
    sample_curves(before.curves, before.skeleton, seconds, frame);
    return frame;
  }
  static double angle(const Quat& a, const Quat& b) {
    return 2.0 * std::acos(std::min(1.0, std::abs(glm::dot(a, b)))) * radians_to_degrees;
  }

  EditedMotion edited, before;
};

TEST_F(MotionEdit, AddsAKeyWithoutMovingTheCurve) {
  ASSERT_TRUE(apply({{"operation", "add_key"}, {"joint", "Head"}, {"axis", "x"}, {"time", 0.77}}));
  EXPECT_EQ(head().segments(), head_before().segments() + 1);
  for (double t = 0.0; t < 1.9; t += 0.01) EXPECT_NEAR(head().value(t), head_before().value(t), 1e-9);
}

TEST_F(MotionEdit, SetsMovesAndDeletesAKeyNearIt) {
  ASSERT_TRUE(apply({{"operation", "add_key"}, {"joint", "head"}, {"axis", "x"}, {"time", 0.5}}));
  ASSERT_TRUE(apply({{"operation", "add_key"}, {"joint", "head"}, {"axis", "x"}, {"time", 0.9}}));
  ASSERT_TRUE(apply({{"operation", "add_key"}, {"joint", "head"}, {"axis", "x"}, {"time", 1.3}}));
  ASSERT_TRUE(apply(
      {{"operation", "set_key"}, {"joint", "head"}, {"axis", "x"}, {"time", 0.9}, {"value", 40.0}, {"slope", 5.0}}));
  EXPECT_NEAR(head().value(0.9), 40.0, 1e-9);
  EXPECT_NEAR(head().slope(0.9), 5.0, 1e-6);
  EXPECT_NEAR(head().value(0.4), head_before().value(0.4), 1e-9);
  EXPECT_LE(head().largest_jump().value, 1e-9);
  EXPECT_LE(head().largest_jump().slope, 1e-6);
  ASSERT_TRUE(apply({{"operation", "move_key"}, {"joint", "head"}, {"axis", "x"}, {"time", 0.9}, {"to", 1.0}}));
  EXPECT_NEAR(head().value(1.0), 40.0, 1e-9);
  EXPECT_NEAR(head().slope(1.0), 5.0, 1e-6);
  EXPECT_LE(head().largest_jump().slope, 1e-6);
  const std::size_t segments = head().segments();
  ASSERT_TRUE(apply({{"operation", "delete_key"}, {"joint", "head"}, {"axis", "x"}, {"time", 1.0}}));
  EXPECT_EQ(head().segments(), segments - 1);
  EXPECT_LE(head().largest_jump().value, 1e-9);
  EXPECT_LE(head().largest_jump().slope, 1e-6);
}

TEST_F(MotionEdit, ScalesAndOffsets) {
  ASSERT_TRUE(apply({{"operation", "scale"}, {"joint", "Head"}, {"axis", "x"}, {"factor", 2.0}}));
  ASSERT_TRUE(apply({{"operation", "offset"}, {"joint", "Head"}, {"axis", "x"}, {"degrees", 7.0}}));
  const double first = head_before().value(0.0);
  for (double t = 0.0; t < 1.9; t += 0.1)
    EXPECT_NEAR(head().value(t), first + 2.0 * (head_before().value(t) - first) + 7.0, 1e-9);
}

TEST_F(MotionEdit, WarpsAndCrops) {
  const double length = before.curves.duration();
  ASSERT_TRUE(apply({{"operation", "warp"}, {"factor", 2.0}}));
  EXPECT_NEAR(edited.curves.duration(), 2.0 * length, 1e-9);
  EXPECT_NEAR(head().value(1.0), head_before().value(0.5), 1e-9);
  ASSERT_TRUE(apply({{"operation", "crop"}, {"from", 1.0}, {"to", 2.0}}));
  EXPECT_NEAR(edited.curves.duration(), 1.0, 1e-9);
  EXPECT_EQ(edited.curves.frames(), 31u);
  EXPECT_NEAR(head().value(0.4), head_before().value(0.7), 1e-9);
  ASSERT_TRUE(apply({{"operation", "warp"}, {"times", {{0.0, 0.0}, {0.5, 0.2}, {1.0, 1.0}}}}));
  // Fitted anew within a tenth of a degree; the corner at 0.2 s is as sharp as a frame.
  EXPECT_NEAR(head().value(0.2), head_before().value(0.75), 0.6);
}

TEST_F(MotionEdit, MirrorsTwiceToItself) {
  ASSERT_TRUE(apply({{"operation", "mirror"}}));
  EXPECT_GT(angle(frame(0.6).rotations[3], frame_before(0.6).rotations[3]), 10.0);
  // The left arm's turn about z becomes the right arm's, the other way round.
  EXPECT_LT(angle(frame(0.6).rotations[4], glm::conjugate(frame_before(0.6).rotations[3])), 0.5);
  EXPECT_NEAR(frame(1.0).root.x, -frame_before(1.0).root.x, 0.01);
  ASSERT_TRUE(apply({{"operation", "mirror"}}));
  for (double t = 0.0; t < 1.9; t += 0.1)
    for (int j = 0; j < 5; ++j) EXPECT_LT(angle(frame(t).rotations[j], frame_before(t).rotations[j]), 0.7);
}

TEST_F(MotionEdit, LoopsJoinsFadesAndLayers) {
  const double length = before.curves.duration();
  ASSERT_TRUE(apply({{"operation", "loop"}, {"count", 3}, {"blend", 0.3}}));
  EXPECT_NEAR(edited.curves.duration(), 3.0 * length - 0.6, 1.0 / 30.0);
  // Walking goes on: no step back to the begin.
  for (double t = 0.1; t < edited.curves.duration(); t += 0.1)
    EXPECT_GT(edited.curves.root[2].value(t), edited.curves.root[2].value(t - 0.1));
  edited = before;
  ASSERT_TRUE(apply({{"operation", "join"}, {"clip", "other"}, {"blend", 0.4}}));
  EXPECT_NEAR(edited.curves.duration(), 2.0 * length - 0.4, 1.0 / 30.0);
  edited = before;
  ASSERT_TRUE(apply({{"operation", "cross_fade"}, {"clip", "other"}, {"from", 0.5}, {"to", 1.0}}));
  EXPECT_LT(angle(frame(0.4).rotations[3], frame_before(0.4).rotations[3]), 0.5);
  EXPECT_NEAR(edited.curves.joints[3].angles[2].value(1.5), 0.5 * before.curves.joints[3].angles[2].value(1.5), 0.5);
  edited = before;
  ASSERT_TRUE(apply({{"operation", "layer"}, {"clip", "other"}, {"joints", {"LeftArm"}}}));
  EXPECT_NEAR(edited.curves.joints[3].angles[2].value(0.6), 0.5 * before.curves.joints[3].angles[2].value(0.6), 0.5);
  EXPECT_NEAR(head().value(0.6), head_before().value(0.6), 0.3);
}

TEST_F(MotionEdit, RefusesWhatDoesNotFit) {
  for (const Json& edit :
       std::vector<Json>{{{"operation", "scael"}},
                         {{"operation", "scale"}, {"joint", "Haed"}, {"factor", 2}},
                         {{"operation", "scale"}, {"joint", "Head"}},
                         {{"operation", "offset"}, {"joint", "Head"}, {"axis", "w"}, {"degrees", 1}},
                         {{"operation", "set_key"}, {"joint", "Head"}, {"axis", "x"}, {"time", 50}, {"value", 1}},
                         {{"operation", "delete_key"}, {"joint", "Head"}, {"axis", "x"}, {"time", 0}},
                         {{"operation", "crop"}, {"from", 1.0}, {"to", 0.5}},
                         {{"operation", "join"}, {"clip", "none"}, {"blend", 0.1}},
                         {{"operation", "loop"}, {"count", 3}, {"blend", 50}},
                         {{"operation", "warp"}, {"factor", -1}}}) {
    const auto applied = apply(edit);
    ASSERT_FALSE(applied) << edit;
    EXPECT_EQ(applied.error().kind, ErrorKind::bad_input);
    EXPECT_NE(applied.error().message.find("/0"), std::string::npos) << applied.error().message;
    EXPECT_EQ(head().coefficients, head_before().coefficients);
  }
}

}  // namespace
}  // namespace sinew
