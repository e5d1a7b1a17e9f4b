#include "engine/face/face_track.h"

#include <gtest/gtest.h>

#include "engine/face/drawn_head.h"

namespace sinew::test {
namespace {

FaceTrack track_of(const Character& character) {
  auto track = face_track(character);
  EXPECT_TRUE(track) << (track ? "" : track.error().message);
  return track ? std::move(*track) : FaceTrack{};
}

Keyed<ExpressionWeight> keys(std::vector<Key<ExpressionWeight>> list, Ease ease = Ease::linear) {
  return {std::move(list), ease};
}

double strength_of(const FaceTrack& track, std::string_view name, double frame) {
  double sum = 0.0;
  for (const WeighedExpression& shown : expressions_at(track, frame))
    if (shown.expression->name == name) sum += shown.strength;
  return sum;
}

TEST(FaceTrack, NeighbouringKeysCrossFade) {
  Character character;
  character.expressions =
      keys({{0, {Expression::smile, 1.0}}, {10, {Expression::anger, 0.5}}, {20, {Expression::neutral, 1.0}}});
  const FaceTrack track = track_of(character);
  EXPECT_DOUBLE_EQ(strength_of(track, "smile", -5), 1.0);
  EXPECT_DOUBLE_EQ(strength_of(track, "smile", 4), 0.6);
  EXPECT_DOUBLE_EQ(strength_of(track, "anger", 4), 0.2);
  EXPECT_DOUBLE_EQ(strength_of(track, "smile", 10), 0.0);
  EXPECT_DOUBLE_EQ(strength_of(track, "anger", 15), 0.25);
  EXPECT_TRUE(expressions_at(track, 99).empty());
}

TEST(FaceTrack, ACubicGoesOnThroughItsKeysAndNeverBeyondThem) {
  Character character;
  character.expressions = keys({{0, {Expression::neutral, 0.0}},
                                {10, {Expression::smile, 0.5}},
                                {20, {Expression::smile, 1.0}},
                                {30, {Expression::neutral, 0.0}}},
                               Ease::cubic);
  const FaceTrack track = track_of(character);
  for (double frame = 0; frame <= 30; frame += 0.5) {
    const double strength = strength_of(track, "smile", frame);
    EXPECT_GE(strength, 0.0) << frame;
    EXPECT_LE(strength, 1.0) << frame;
  }
  EXPECT_DOUBLE_EQ(strength_of(track, "smile", 10), 0.5);
  // It does not halt at the second key, and does at the third, its highest.
  EXPECT_GT(strength_of(track, "smile", 10.5) - strength_of(track, "smile", 9.5), 0.03);
  EXPECT_LT(1.0 - strength_of(track, "smile", 19.5), 0.01);
}

TEST(FaceTrack, ACueComesStaysAndGoes) {
  const ExpressionCue cue{.expression = "laugh", .start = 12, .until = 40, .fade = 6, .strength = 0.8};
  EXPECT_EQ(cue_strength(cue, 11.9), 0.0);
  EXPECT_DOUBLE_EQ(cue_strength(cue, 15), 0.4);
  EXPECT_DOUBLE_EQ(cue_strength(cue, 18), 0.8);
  EXPECT_DOUBLE_EQ(cue_strength(cue, 40), 0.8);
  EXPECT_DOUBLE_EQ(cue_strength(cue, 43), 0.4);
  EXPECT_NEAR(cue_strength(cue, 46), 0.0, 1e-12);
  EXPECT_EQ(cue_strength(cue, 47), 0.0);
}

TEST(FaceTrack, ACueStopsWhereItIsToldAndMayCutInAtOnce) {
  ExpressionCue cue{.expression = "blink", .start = 5, .until = 5, .stop = 9, .fade = 6};
  EXPECT_EQ(cue_strength(cue, 4.99), 0.0);
  EXPECT_DOUBLE_EQ(cue_strength(cue, 5), 1.0);
  EXPECT_DOUBLE_EQ(cue_strength(cue, 7), 0.5);
  EXPECT_EQ(cue_strength(cue, 9.01), 0.0);
  cue.ease = Ease::smooth;
  EXPECT_DOUBLE_EQ(cue_strength(cue, 6), 1.0 - smoothstep01(0.25));
}

TEST(FaceTrack, CuesAndRegionsAddToTheKeys) {
  Character character;
  character.expressions = keys({{0, {Expression::smile, 1.0}}});
  character.cues = {{.expression = "blinkLeft", .start = 0, .until = 10, .fade = 0}};
  character.regions["jaw"] = {{{0, {0.0}}, {10, {0.2}}}, Ease::linear};
  character.regions["browLeft"] = Keyed<std::vector<double>>::constant({0.01, 0.02, 3.0});
  const FaceTrack track = track_of(character);
  EXPECT_DOUBLE_EQ(strength_of(track, "smile", 5), 1.0);
  EXPECT_DOUBLE_EQ(strength_of(track, "blinkLeft", 5), 1.0);
  const FaceChannels regions = regions_at(track, 5);
  EXPECT_DOUBLE_EQ(channel(regions, FaceChannel::jaw_drop), 0.1);
  EXPECT_DOUBLE_EQ(channel(regions, FaceChannel::brow_left_right), 0.01);
  EXPECT_DOUBLE_EQ(channel(regions, FaceChannel::brow_left_up), 0.02);
  EXPECT_DOUBLE_EQ(channel(regions, FaceChannel::brow_left_turn), 3.0);
  EXPECT_EQ(reach_of(track), (std::pair{0.0, 10.0}));
}

TEST(FaceTrack, AnUnknownCueNamesTheNearestExpression) {
  Character character;
  character.cues = {{.expression = "laugth", .start = 0, .until = 1}};
  const auto track = face_track(character);
  ASSERT_FALSE(track);
  EXPECT_EQ(track.error().kind, ErrorKind::bad_input);
  EXPECT_NE(track.error().message.find("/expressions: "), std::string::npos);
  EXPECT_NE(track.error().message.find("\"laugh\""), std::string::npos) << track.error().message;
}

}  // namespace
}  // namespace sinew::test
