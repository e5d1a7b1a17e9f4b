#include "engine/view/face_edit.h"

#include <random>

#include "engine/view/face_picture.h"
#include "tests/view/opened_document.h"

namespace sinew::test {
namespace {

using C = FaceChannel;

ShownFace face_of(const Document& document, double frame = 0.0) {
  auto face = shown_face(document.stage().characters[0], frame);
  EXPECT_TRUE(face);
  return std::move(*face);
}

void move(Document& document, std::vector<ChannelGoal> goals, double frame = 0.0) {
  Scene scene = document.scene();
  move_channels(scene.characters[0], face_of(document, frame), frame, goals);
  const auto done = document.edit(scene, "move");
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_NE(*done, Touched::all) << "nothing on the device is made anew";
}

void show(Document& document, Expression expression, double strength, double frame = 0.0) {
  Scene scene = document.scene();
  set_expression(scene.characters[0], frame, expression, strength);
  ASSERT_TRUE(document.edit(scene, "show"));
}

TEST(FaceEdit, HandlesStopAtTheLimits) {
  Document document = opened("builtin:head");
  const ShownFace rest = face_of(document);
  move(document, {{C::jaw_drop, 99.0}});
  EXPECT_EQ(channel(face_of(document).shown, C::jaw_drop), rest.sizes.limits.chin_drop);
  move(document, {{C::corner_left_right, -99.0}, {C::corner_left_up, 0.05}});
  EXPECT_EQ(channel(face_of(document).shown, C::corner_left_right), -rest.sizes.limits.corner_in);
  EXPECT_EQ(channel(face_of(document).shown, C::corner_left_up), 0.05);
  EXPECT_EQ(document.scene().characters[0].regions.size(), 2u) << "what was not moved has no numbers";
  ASSERT_TRUE(document.undo());
  ASSERT_TRUE(document.undo());
  EXPECT_TRUE(document.scene().characters[0].regions.empty());
}

TEST(FaceEdit, ALipPushesTheOther) {
  Document document = opened("builtin:head");
  move(document, {{C::upper_lip_up, 0.08}});
  move(document, {{C::lower_lip_up, 0.06}});
  move(document, {{C::upper_lip_up, 0.02}});
  EXPECT_EQ(channel(face_of(document).shown, C::lower_lip_up), 0.02);
  EXPECT_TRUE(document.stage().characters[0].face.held.empty()) << "nothing is asked for that cannot be";
}

// Whatever is dragged on top of whatever expression, no limit is left to hold anything.
TEST(FaceEdit, NoBadCombinationCanBeMade) {
  Document document = opened("builtin:head");
  std::mt19937 random(7);
  std::uniform_real_distribution<double> amount(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    if (i % 20 == 0) show(document, static_cast<Expression>(i / 20), 1.0);
    const auto c = static_cast<C>(random() % face_channels);
    const double reach = face_channel_names()[static_cast<std::size_t>(c)].number == std::string("turn") ? 40.0 : 1.0;
    move(document, {{c, reach * amount(random)}});
    if (i % 20 != 0) continue;
    Scene scene = document.scene();
    scene.characters[0].regions.clear();
    ASSERT_TRUE(document.edit(scene, "rest"));
  }
  for (const HeldKey& held : document.stage().characters[0].face.held)
    EXPECT_NEAR(held.held.asked, held.held.held, 1e-12) << channel_word(held.held.channel);
}

TEST(FaceEdit, ExpressionsAreOneAtAKeyAndCrossFade) {
  Document document = opened("builtin:head");
  show(document, Expression::smile, 0.5);
  show(document, Expression::laugh, 1.0);
  EXPECT_EQ(document.scene().characters[0].expressions->keys.size(), 1u) << "a face that rests changes as a whole";
  Scene scene = document.scene();
  add_face_key(scene.characters[0], face_of(document), 10.0);
  ASSERT_TRUE(document.edit(scene, "key"));
  show(document, Expression::anger, 1.0, 10.0);
  EXPECT_DOUBLE_EQ(face_of(document, 5.0).strengths[static_cast<std::size_t>(Expression::laugh)], 0.5);
  EXPECT_DOUBLE_EQ(face_of(document, 5.0).strengths[static_cast<std::size_t>(Expression::anger)], 0.5);
  scene = document.scene();
  remove_face_key(scene.characters[0], 10.0);
  remove_face_key(scene.characters[0], 0.0);
  EXPECT_FALSE(scene.characters[0].expressions);
}

TEST(FaceEdit, AKeyKeepsTheFace) {
  Document document = opened("builtin:head");
  move(document, {{C::jaw_drop, 0.2}});
  show(document, Expression::surprise, 1.0);
  const FaceChannels before = face_of(document).shown;
  Scene scene = document.scene();
  add_face_key(scene.characters[0], face_of(document), 12.0);
  add_face_key(scene.characters[0], face_of(document), 0.0);
  ASSERT_TRUE(document.edit(scene, "key"));
  move(document, {{C::jaw_drop, 0.0}}, 12.0);
  EXPECT_EQ(face_of(document, 0.0).shown, before);
  EXPECT_LT(channel(face_of(document, 12.0).shown, C::jaw_drop), channel(before, C::jaw_drop));
}

TEST(FaceEdit, AModelWithoutRegionsHasNoFace) {
  const Document document = opened("builtin:arm");
  EXPECT_FALSE(shown_face(document.stage().characters[0], 0.0));
}

TEST(FacePicture, HandlesGoWhereTheyArePulled) {
  Document document = opened("builtin:head");
  show(document, Expression::smile, 0.6);
  const ShownFace face = face_of(document);
  const FaceGuides guides = document.stage().characters[0].mesh.face->guides;
  const std::size_t count = face_picture(face, guides).handles.size();
  EXPECT_EQ(count, 18u);
  for (std::size_t i = 0; i < count; ++i) {
    const FaceHandle handle = face_picture(face, guides).handles[i];
    // Half of the way to a corner of what it can reach.
    const Vec2 by = 0.5 * (handle.reach(face).back() - handle.at);
    if (glm::length(by) < 1e-6) continue;
    Scene scene = document.scene();
    move_channels(scene.characters[0], face, 0.0, handle.pulled(face, by));
    ASSERT_TRUE(document.edit(scene, handle.name));
    const Vec2 came = face_picture(face_of(document), guides).handles[i].at - handle.at;
    // Turns and gaze go on arcs, and the mouth opens by more than the jaw's own point: the way is what counts.
    EXPECT_GT(glm::dot(came, by), 0.7 * glm::dot(by, by)) << handle.name;
    EXPECT_LT(glm::length(came - by), 0.45 * glm::length(by)) << handle.name;
    ASSERT_TRUE(document.undo());
  }
}

TEST(FacePicture, StaysWithinItsFrame) {
  for (const char* age : {"adult", "infant"}) {
    Document document = opened("builtin:head");
    Scene scene = document.scene();
    set_head_age(scene.characters[0], 0.0, std::string(age) == "adult" ? 0.0 : 1.0);
    ASSERT_TRUE(document.edit(scene, "age"));
    for (const Expression expression : {Expression::neutral, Expression::surprise, Expression::shout}) {
      show(document, expression, 2.0);
      const FacePicture picture = face_picture(face_of(document), document.stage().characters[0].mesh.face->guides);
      for (const FaceHandle& handle : picture.handles) {
        EXPECT_TRUE(glm::all(glm::greaterThan(handle.at, face_picture_low))) << age << " " << handle.name;
        EXPECT_TRUE(glm::all(glm::lessThan(handle.at, face_picture_high))) << age << " " << handle.name;
      }
    }
  }
}

TEST(FaceEdit, SkullsOfEveryAgeAreHeads) {
  for (int corner = 0; corner < 16; ++corner)
    for (const double age : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      Character character;
      for (std::size_t i = 0; i < 4; ++i) {
        const double wanted = (corner >> i) & 1;
        set_skull(character, skull_names()[i], wanted);
        const auto found = character.head->skull.find(skull_names()[i]);
        EXPECT_EQ(found == character.head->skull.end() ? 0.0 : found->second, wanted) << corner;
      }
      set_head_age(character, 0.0, age);
      const auto measures = head_measures(*character.head, 0.0);
      EXPECT_TRUE(measures) << measures.error().message << " corner " << corner << ", age " << age;
    }
}

}  // namespace
}  // namespace sinew::test
