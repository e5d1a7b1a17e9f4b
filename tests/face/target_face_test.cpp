#include "engine/face/target_face.h"

#include <gtest/gtest.h>

#include "engine/face/face_shapes.h"
#include "tests/support/tube.h"

namespace sinew::test {
namespace {

/// A mesh with a morph target of each name; what they do does not matter here.
Model model_with(const std::vector<std::string>& names) {
  Model model = tube({.rows = 3, .columns = 4});
  Primitive& skin = model.meshes[0].primitives[0];
  for (const std::string& name : names)
    skin.morph_targets.push_back({name, std::vector<Vec3>(skin.positions.size(), Vec3(0.1, 0, 0)), {}});
  model.meshes[0].morph_weights.assign(names.size(), 0.0);
  return model;
}

std::map<std::string, double> weights_of(const std::vector<std::string>& names, const Character& character,
                                         double frame) {
  const Model model = model_with(names);
  const CharacterMesh mesh = character_mesh(model);
  auto face = TargetFace::find(model, mesh);
  EXPECT_TRUE(face);
  const auto track = face_track(character);
  EXPECT_TRUE(track);
  if (!face || !track) return {};
  const auto ready = face->prepare(*track);
  EXPECT_TRUE(ready) << (ready ? "" : ready.error().message);
  std::vector<double> weights(mesh.morph_slots.size(), 0.0);
  face->add_weights(*track, frame, weights);
  std::map<std::string, double> out;
  for (std::size_t i = 0; i < names.size(); ++i) out[names[i]] = weights[i];
  return out;
}

Character showing(Expression expression, double strength) {
  Character character;
  character.expressions = {{{0, {Expression::neutral, 1.0}}, {10, {expression, strength}}}, Ease::linear};
  return character;
}

const std::vector<std::string> arkit{"browInnerUp",      "browDownLeft",      "browDownRight",    "eyeBlinkLeft",
                                     "eyeBlinkRight",    "eyeSquintLeft",     "eyeSquintRight",   "eyeWideLeft",
                                     "eyeWideRight",     "mouthSmileLeft",    "mouthSmileRight",  "mouthFrownLeft",
                                     "mouthFrownRight",  "cheekSquintLeft",   "cheekSquintRight", "jawOpen",
                                     "mouthUpperUpLeft", "mouthUpperUpRight", "noseSneerLeft",    "noseSneerRight"};

TEST(TargetFace, TellsBeforehandWhatItWouldRefuse) {
  for (const auto& names : {arkit, {"jawOpen", "smile"}, {"happy", "angry", "aa"}, {"blink"}}) {
    const Model model = model_with(names);
    const CharacterMesh mesh = character_mesh(model);
    auto face = TargetFace::find(model, mesh);
    ASSERT_TRUE(face);
    for (const FacePreset& preset : expressions()) {
      FaceTrack track;
      track.keys.push_back({&preset, Keyed<double>::constant(1.0)});
      EXPECT_EQ(face->can_show(preset), face->prepare(track).has_value()) << preset.name;
    }
    EXPECT_EQ(face->can_show(**find_expression("smile")), names != std::vector<std::string>{"blink"});
    EXPECT_EQ(face->can_show(**find_expression("sadness")), names == arkit) << "few targets make few expressions";
    for (std::size_t c = 0; c < face_channels; ++c)
      for (const double value : {-0.1, 0.1}) {
        FaceTrack track;
        track.regions.push_back({c, Keyed<std::vector<double>>::constant({value})});
        EXPECT_EQ(face->can_move(c, value > 0.0), face->prepare(track).has_value());
      }
    const auto jaw = static_cast<std::size_t>(FaceChannel::jaw_drop);
    EXPECT_EQ(face->can_move(jaw, true), names != std::vector<std::string>{"blink"});
    EXPECT_FALSE(face->can_move(jaw, false)) << "no target closes a closed jaw";
  }
}

TEST(TargetFace, ATargetOfTheExpressionsNameIsTheExpression) {
  const auto weights = weights_of({"jawOpen", "smile"}, showing(Expression::smile, 0.8), 5);
  EXPECT_DOUBLE_EQ(weights.at("smile"), 0.4);
  EXPECT_DOUBLE_EQ(weights.at("jawOpen"), 0.0);
}

TEST(TargetFace, VrmPresetsStandInForTheThesisWords) {
  EXPECT_DOUBLE_EQ(weights_of({"happy", "angry", "aa"}, showing(Expression::smile, 1.0), 10).at("happy"), 1.0);
  EXPECT_DOUBLE_EQ(weights_of({"Joy", "Angry", "A"}, showing(Expression::anger, 1.0), 10).at("Angry"), 1.0);
  // VRM has no laugh: joy with an open mouth.
  const auto laugh =
      weights_of({"happy", "angry", "sad", "surprised", "aa", "blink"}, showing(Expression::laugh, 1.0), 10);
  EXPECT_GT(laugh.at("happy"), 0.5);
  EXPECT_GT(laugh.at("aa") + laugh.at("surprised"), 0.1);
  EXPECT_LT(laugh.at("sad"), 0.1);
}

TEST(TargetFace, ArkitShapesAreMixed) {
  const auto smile = weights_of(arkit, showing(Expression::smile, 1.0), 10);
  for (const char* raised : {"mouthSmileLeft", "mouthSmileRight", "cheekSquintLeft", "cheekSquintRight"})
    EXPECT_GT(smile.at(raised), 0.3) << raised;
  for (const char* still : {"mouthFrownLeft", "browDownRight", "eyeWideLeft"})
    EXPECT_LT(smile.at(still), 0.05) << still;
  EXPECT_DOUBLE_EQ(smile.at("mouthSmileLeft"), smile.at("mouthSmileRight"));
  const auto surprise = weights_of(arkit, showing(Expression::surprise, 1.0), 10);
  EXPECT_GT(surprise.at("eyeWideLeft"), 0.5);
  EXPECT_GT(surprise.at("jawOpen"), 0.2);
}

TEST(TargetFace, OtherMakersSpellingsAreKnown) {
  std::vector<std::string> spelt;
  for (std::string name : arkit) {
    for (const auto& [side, letter] : {std::pair{"Left", "_L"}, {"Right", "_R"}})
      if (name.ends_with(side)) name = name.substr(0, name.size() - std::string(side).size()) + letter;
    spelt.push_back("head_shapes." + name);
  }
  const auto weights = weights_of(spelt, showing(Expression::smile, 1.0), 10);
  EXPECT_GT(weights.at("head_shapes.mouthSmile_L"), 0.3);
}

TEST(TargetFace, RegionsMoveOurShapesExactlyAndOthersAsNearAsTheyCan) {
  Character character;
  character.regions["jaw"] = Keyed<std::vector<double>>::constant({0.275});
  character.regions["cornerLeft"] = Keyed<std::vector<double>>::constant({0.0, -0.06});
  const auto own = weights_of({"jaw+", "cornerLeft.up+", "cornerLeft.up-", "laugh"}, character, 0);
  // Half of an adult's limits, 0.55 and 0.12; what spares weights takes a hundredth.
  EXPECT_NEAR(own.at("jaw+"), 0.5, 0.01);
  EXPECT_NEAR(own.at("cornerLeft.up-"), 0.5, 0.01);
  EXPECT_EQ(own.at("cornerLeft.up+"), 0.0);
  EXPECT_NEAR(weights_of(arkit, character, 0).at("jawOpen"), 0.5, 0.02);
}

TEST(TargetFace, WhatNoTargetMakesIsSaid) {
  const Model model = model_with({"jawOpen"});
  const CharacterMesh mesh = character_mesh(model);
  auto face = TargetFace::find(model, mesh);
  ASSERT_TRUE(face);
  const auto smile = face->prepare(*face_track(showing(Expression::smile, 1.0)));
  ASSERT_FALSE(smile);
  EXPECT_NE(smile.error().message.find("\"smile\""), std::string::npos) << smile.error().message;
  Character character;
  character.regions["nose"] = Keyed<std::vector<double>>::constant({0.05});
  const auto nose = face->prepare(*face_track(character));
  ASSERT_FALSE(nose);
  EXPECT_EQ(nose.error().message.substr(0, 15), "/regions/nose: ");
}

TEST(TargetFace, AModelWithoutKnownNamesHasNoFace) {
  const Model model = model_with({"fat", "Key 1"});
  EXPECT_FALSE(TargetFace::find(model, character_mesh(model)));
}

}  // namespace
}  // namespace sinew::test
