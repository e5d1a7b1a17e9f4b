/// Expressions against the tables of Yen 1990, 4.2.1: written here a second time, in words.

#include "engine/face/expression.h"

#include "tests/face/head_fixture.h"

namespace sinew::test {
namespace {

using C = FaceChannel;

FaceChannels of(const std::string& name, bool strict) { return find_expression(name).value()->channels(strict); }
double at(const FaceChannels& channels, C c) { return channel(channels, c); }

struct Direction {
  const char* expression;
  C channel;
  int sign;
};

class Directions : public testing::TestWithParam<Direction> {};

TEST_P(Directions, AreTheTables) {
  const Direction& d = GetParam();
  // The thesis' own moves alone, and all of them together, go the same way.
  for (const bool strict : {true, false})
    EXPECT_GT(d.sign * at(of(d.expression, strict), d.channel), 0.0) << d.expression << " strict " << strict;
}

INSTANTIATE_TEST_SUITE_P(
    Table, Directions,
    testing::Values(Direction{"smile", C::upper_lid_left, 1}, Direction{"smile", C::upper_lip_up, 1},
                    Direction{"smile", C::corner_left_right, 1}, Direction{"smile", C::corner_right_right, -1},
                    Direction{"smile", C::corner_left_up, 1}, Direction{"laugh", C::upper_lid_left, 1},
                    Direction{"laugh", C::upper_lip_up, 1}, Direction{"laugh", C::lower_lip_up, -1},
                    Direction{"laugh", C::corner_left_right, 1}, Direction{"laugh", C::corner_left_up, 1},
                    Direction{"anger", C::brow_left_right, -1}, Direction{"anger", C::brow_right_right, 1},
                    Direction{"anger", C::brow_left_turn, 1}, Direction{"anger", C::brow_right_turn, -1},
                    Direction{"anger", C::upper_lip_up, 1}, Direction{"surprise", C::brow_left_up, 1},
                    Direction{"surprise", C::upper_lid_left, -1}, Direction{"shout", C::brow_left_up, 1},
                    Direction{"shout", C::upper_lip_up, 1}, Direction{"shout", C::lower_lip_up, -1},
                    Direction{"shout", C::corner_left_right, -1}, Direction{"shout", C::jaw_drop, 1},
                    Direction{"fear", C::brow_left_up, 1}, Direction{"fear", C::upper_lid_left, -1},
                    Direction{"fear", C::upper_lip_up, 1}, Direction{"fear", C::lower_lip_up, -1},
                    Direction{"fear", C::jaw_drop, 1}, Direction{"sadness", C::brow_left_right, -1},
                    Direction{"sadness", C::upper_lid_left, 1}, Direction{"sadness", C::corner_left_right, 1},
                    Direction{"sadness", C::corner_left_up, -1}, Direction{"disgust", C::upper_lip_up, 1}));

TEST(Expressions, LaughGoesFurtherThanSmile) {
  const FaceChannels smile = of("smile", true), laugh = of("laugh", true);
  for (const C c : {C::upper_lid_left, C::upper_lip_up, C::corner_left_right, C::corner_left_up})
    EXPECT_GT(at(laugh, c), at(smile, c));
}

TEST(Expressions, ActionUnitsHoldWhereTheTableIsSilent) {
  // Ekman and Friesen: sadness 1+4 (inner brows up), fear 1+2+4, joy 6, anger 4 (brows down) and 7, disgust 4 and 10.
  EXPECT_LT(at(of("sadness", false), C::brow_left_turn), 0.0);
  EXPECT_LT(at(of("fear", false), C::brow_left_turn), 0.0);
  EXPECT_GT(at(of("smile", false), C::cheek_left_up), 0.0);
  EXPECT_LT(at(of("anger", false), C::brow_left_up), 0.0);
  EXPECT_GT(at(of("anger", false), C::lower_lid_left), 0.0);
  EXPECT_LT(at(of("disgust", false), C::brow_left_up), 0.0);
  EXPECT_GT(at(of("disgust", false), C::nose_wrinkle), 0.0);
}

TEST(Expressions, DoubtIsNotSymmetricAndTheOthersAre) {
  const FaceChannels doubt = of("doubt", true);
  EXPECT_TRUE((at(doubt, C::brow_left_up) > 0.0) != (at(doubt, C::brow_right_up) > 0.0));
  EXPECT_LT(at(doubt, C::upper_lid_left) * at(doubt, C::upper_lid_right), 0.0);
  EXPECT_TRUE((at(doubt, C::corner_left_right) != 0.0) != (at(doubt, C::corner_right_right) != 0.0));
  EXPECT_EQ(at(doubt, C::jaw_drop), 0.0);
  for (const char* name : {"smile", "laugh", "anger", "surprise", "shout", "fear", "sadness", "disgust"}) {
    const FaceChannels c = of(name, false);
    EXPECT_EQ(at(c, C::brow_left_right), -at(c, C::brow_right_right)) << name;
    EXPECT_EQ(at(c, C::brow_left_turn), -at(c, C::brow_right_turn)) << name;
    EXPECT_EQ(at(c, C::upper_lid_left), at(c, C::upper_lid_right)) << name;
    EXPECT_EQ(at(c, C::corner_left_right), -at(c, C::corner_right_right)) << name;
    EXPECT_EQ(at(c, C::corner_left_up), at(c, C::corner_right_up)) << name;
  }
}

struct Uses {
  const char* expression;
  bool brows, lids, lips, corners, jaw;
};

TEST(Expressions, StrictUseTheRegionsOfTheTableAndNoOther) {
  // Surprise and shout share a column: together they use it all.
  const Uses table[] = {{"smile", false, true, true, true, false},   {"laugh", false, true, true, true, false},
                        {"anger", true, false, true, false, false},  {"surprise", true, true, true, true, true},
                        {"shout", true, true, true, true, true},     {"fear", true, true, true, false, true},
                        {"sadness", true, true, false, true, false}, {"doubt", true, true, true, true, false}};
  for (const Uses& row : table) {
    const FaceChannels c = of(row.expression, true);
    const auto uses = [&](std::initializer_list<C> list) {
      for (const C k : list)
        if (at(c, k) != 0.0) return true;
      return false;
    };
    EXPECT_EQ(uses({C::brow_left_right, C::brow_left_up, C::brow_left_turn, C::brow_right_up}), row.brows)
        << row.expression;
    EXPECT_EQ(uses({C::upper_lid_left, C::upper_lid_right, C::lower_lid_left, C::lower_lid_right}), row.lids)
        << row.expression;
    EXPECT_EQ(uses({C::upper_lip_up, C::lower_lip_up, C::lip_press, C::lip_pucker}), row.lips) << row.expression;
    EXPECT_EQ(uses({C::corner_left_right, C::corner_left_up, C::corner_right_right, C::corner_right_up}), row.corners)
        << row.expression;
    EXPECT_EQ(uses({C::jaw_drop}), row.jaw) << row.expression;
    EXPECT_FALSE(uses({C::cheek_left_up, C::nose_wrinkle})) << row.expression;
  }
}

TEST(Expressions, AllLieWithinTheLimitsAtFullStrength) {
  const FaceRig& face = head_of("adult").face;
  for (const auto list : {expressions(), arkit_shapes()})
    for (const FacePreset& e : list) {
      FaceChannels c = for_head(face, e.channels(false));
      for (std::size_t i = 0; i < face_channels; ++i) c[i] += e.from[i];
      const HeldFace held = hold_at_limits(face, c);
      EXPECT_TRUE(held.held.empty()) << e.name << ": channel " << static_cast<int>(held.held[0].channel) << " asked "
                                     << held.held[0].asked << " held " << held.held[0].held;
    }
}

TEST(Expressions, NoTwoAreAlike) {
  // Root mean square over the vertices that any of them moves, drawing units: 0.01 is a third of a percent of the
  // head's height, a lid or a corner that has plainly moved.
  constexpr double margin = 0.01;
  const char* names[] = {"neutral", "smile", "laugh",   "anger", "surprise",
                         "shout",   "fear",  "sadness", "doubt", "disgust"};
  const Head& head = head_of("adult");
  std::vector<std::vector<Vec3>> posed;
  for (const char* name : names) posed.push_back(shown(head, name, 1.0));
  for (std::size_t a = 0; a < posed.size(); ++a)
    for (std::size_t b = a + 1; b < posed.size(); ++b) {
      double sum = 0.0;
      std::size_t moved = 0;
      for (std::size_t v = 0; v < head.positions.size(); ++v) {
        const double d = glm::distance(posed[a][v], posed[b][v]);
        sum += d * d;
        bool any = false;
        for (const auto& p : posed) any = any || p[v] != head.positions[v];
        moved += any;
      }
      EXPECT_GT(std::sqrt(sum / double(moved)), margin) << names[a] << " and " << names[b];
    }
}

TEST(Expressions, EveryVrmPresetIsThere) {
  for (const char* name : {"happy", "angry", "sad", "relaxed", "surprised", "aa", "ih", "ou", "ee", "oh", "blink",
                           "blinkLeft", "blinkRight", "lookUp", "lookDown", "lookLeft", "lookRight", "neutral"})
    EXPECT_TRUE(find_expression(name)) << name;
  EXPECT_EQ(find_expression("smlie").error().kind, ErrorKind::bad_input);
  EXPECT_NE(find_expression("smlie").error().message.find("smile"), std::string::npos);
}

TEST(Expressions, OverridesAreThoseOfVrm) {
  const FacePreset *laugh = find_expression("laugh").value(), *blink = find_expression("blink").value(),
                   *aa = find_expression("aa").value(), *smile = find_expression("smile").value();
  const auto mixed = [](std::vector<WeighedExpression> list) { return mix_expressions(list, false); };
  // Laugh blocks mouths and blinks: nothing of them is left.
  EXPECT_EQ(mixed({{laugh, 0.5}, {blink, 1.0}, {aa, 1.0}}), mixed({{laugh, 0.5}}));
  // Smile weakens a blink by its own strength.
  const double lid = at(smile->channels(false), C::upper_lid_left);
  EXPECT_NEAR(at(mixed({{smile, 0.4}, {blink, 1.0}}), C::upper_lid_left), 0.4 * lid + 0.6, 1e-12);
  EXPECT_NEAR(at(mixed({{blink, 1.0}}), C::upper_lid_left), 1.0, 1e-12);
}

TEST(Expressions, AmountsGoByTheHeadsOwnSizes) {
  const FaceRig& infant = head_of("infant").face;
  FaceChannels c{};
  channel(c, C::jaw_drop) = 0.3;
  channel(c, C::corner_left_up) = 0.1;
  channel(c, C::upper_lid_left) = 0.5;
  const FaceChannels own = for_head(infant, c);
  EXPECT_LT(at(own, C::jaw_drop), 0.25);
  EXPECT_LT(at(own, C::corner_left_up), 0.08);
  EXPECT_EQ(at(own, C::upper_lid_left), 0.5);
}

TEST(Expressions, RegionsAreReadAsScenesNameThem) {
  FaceChannels c{};
  ASSERT_TRUE(add_region("browLeft=0.01,0.1,-5", c));
  ASSERT_TRUE(add_region("jaw=0.2", c));
  EXPECT_EQ(at(c, C::brow_left_turn), -5.0);
  EXPECT_EQ(at(c, C::jaw_drop), 0.2);
  EXPECT_EQ(add_region("jaw", c).error().kind, ErrorKind::usage);
  EXPECT_EQ(add_region("jaw=x", c).error().kind, ErrorKind::usage);
  EXPECT_EQ(add_region("jaw=1,2", c).error().kind, ErrorKind::bad_input);
  EXPECT_NE(add_region("jawl=1", c).error().message.find("did you mean \"jaw\""), std::string::npos);
}

}  // namespace
}  // namespace sinew::test
