#include "engine/app/emotion_use.h"

#include <gtest/gtest.h>

#include "tests/motion/made_up_motion.h"

namespace sinew::test {
namespace {

/// A head that turns about x by the degrees, ten frames a second.
Motion nod(const std::vector<double>& degrees) {
  Motion motion = made_up_motion("nod", static_cast<int>(degrees.size()), 0.0);
  motion.frame_time = 0.1;
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    for (Quat& q : motion.frames[i].rotations) q = Quat(1, 0, 0, 0);
    motion.frames[i].rotations[2] = axis_rotation(0, degrees[i] * degrees_to_radians);
  }
  return motion;
}

const EmotionCue cue{40.0, Expression::laugh, 0.5};

TEST(EmotionUse, SpansWhereTheBodyIsNearItsApex) {
  const Motion motion = nod({0, 5, 15, 17, 10, 20, 12, 16.5, 3, 0});
  ClipEntry clip;
  clip.frames = motion.frames.size();
  clip.frame_time = motion.frame_time;
  const MotionUse use = use_for_cue(cue, clip, 0.5, 20.0);
  const EmotionSpan span = span_of(motion, use, 0.5, 20.0);
  // Four fifths of 20 degrees are 16: first at sample 3, last at sample 7, two frames of the scene each.
  EXPECT_NEAR(span.begin, 30.0, 1e-9);
  EXPECT_NEAR(span.near, 36.0, 1e-9);
  EXPECT_NEAR(span.leaving, 44.0, 1e-9);
  EXPECT_NEAR(span.end, 48.0, 1e-9);
}

TEST(EmotionUse, TheFaceFollowsTheSpan) {
  const auto all = expressions_with(std::nullopt, std::span(&cue, 1), std::vector{EmotionSpan{30, 36, 44, 48}});
  ASSERT_TRUE(all);
  std::vector<double> frames, strengths;
  for (const auto& key : all->keys) {
    frames.push_back(key.frame);
    strengths.push_back(key.value.strength);
    EXPECT_EQ(key.value.expression, key.frame == 30 || key.frame == 48 ? Expression::neutral : Expression::laugh);
  }
  EXPECT_EQ(frames, (std::vector<double>{30, 36, 40, 44, 48}));
  EXPECT_NEAR(strengths[1], 0.4, 1e-12);
  EXPECT_EQ(strengths[2], 0.5);
  EXPECT_NEAR(strengths[3], 0.4, 1e-12);
}

TEST(EmotionUse, OwnKeysGoBefore) {
  Keyed<ExpressionWeight> own;
  own.keys = {{33.0, {Expression::fear, 1.0}}, {60.0, {Expression::smile, 1.0}}};
  const auto all = expressions_with(own, std::span(&cue, 1), std::vector{EmotionSpan{30, 36, 44, 48}});
  ASSERT_TRUE(all);
  std::vector<double> frames;
  for (const auto& key : all->keys) frames.push_back(key.frame);
  EXPECT_EQ(frames, (std::vector<double>{33, 40, 44, 48, 60}));
}

TEST(EmotionUse, AnApexAtEitherEndLeavesOneSide) {
  const Motion falling = nod({0, 20, 10, 0});
  ClipEntry clip;
  clip.frames = falling.frames.size();
  clip.frame_time = falling.frame_time;
  const MotionUse use = use_for_cue(cue, clip, 0.1, 20.0);
  const EmotionSpan span = span_of(falling, use, 0.1, 20.0);
  EXPECT_EQ(span.near, cue.frame);
  EXPECT_EQ(span.leaving, cue.frame);
  const auto all = expressions_with(std::nullopt, std::span(&cue, 1), std::span(&span, 1));
  for (std::size_t i = 1; i < all->keys.size(); ++i) EXPECT_LT(all->keys[i - 1].frame, all->keys[i].frame);
}

}  // namespace
}  // namespace sinew::test
