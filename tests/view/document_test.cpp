#include "engine/view/document.h"

#include <gtest/gtest.h>

#include "engine/core/files.h"
#include "engine/io/scene_file.h"
#include "tests/view/opened_document.h"

namespace sinew::test {
namespace {

Scene turned(const Document& document, double degrees, double frame = 0.0) {
  Scene scene = document.scene();
  set_joint_degrees(scene.characters[0], "leftLowerArm", frame, {0, degrees, 0});
  return scene;
}

Vec3 hand(const Document& document, int frame = 0) {
  const Stage& stage = document.stage();
  const StagedCharacter& character = stage.characters[0];
  const auto node = find_joint(*character.model, character.humanoid, "leftHand");
  return Vec3(character_state(stage, 0, frame).global[static_cast<std::size_t>(*node)][3]);
}

TEST(Document, SpellsOutWhatABareModelHas) {
  const Document document = opened("builtin:woman");
  EXPECT_EQ(document.scene().characters[0].muscles.size(), 4u);
  EXPECT_EQ(document.stage().characters[0].muscles.size(), 4u);
  EXPECT_FALSE(document.is_changed());
}

TEST(Document, EditsShowAndAreUndoneAndDoneAgain) {
  Document document = opened();
  const Vec3 rest = hand(document);
  EXPECT_EQ(*document.edit(turned(document, -90), "turn"), Touched::poses);
  const Vec3 bent = hand(document);
  EXPECT_GT(glm::distance(rest, bent), 0.1);
  EXPECT_TRUE(document.is_changed());
  EXPECT_EQ(document.undo_label(), "turn");
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(hand(document), rest) << "to the bit";
  EXPECT_FALSE(document.is_changed());
  ASSERT_TRUE(document.redo());
  EXPECT_EQ(hand(document), bent);
  EXPECT_FALSE(document.can_redo());
}

TEST(Document, ADraggedSliderIsOneEdit) {
  Document document = opened();
  const Vec3 rest = hand(document);
  for (int i = 1; i <= 20; ++i) ASSERT_TRUE(document.edit(turned(document, -4.0 * i), "turn", "turn elbow"));
  document.seal();
  ASSERT_TRUE(document.edit(turned(document, 10), "turn", "turn elbow"));
  ASSERT_TRUE(document.undo());
  EXPECT_DOUBLE_EQ(joint_degrees(document.scene().characters[0], "leftLowerArm", 0).y, -80.0);
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(hand(document), rest);
  EXPECT_FALSE(document.can_undo());
}

TEST(Document, ANewEditForgetsWhatWasUndone) {
  Document document = opened();
  ASSERT_TRUE(document.edit(turned(document, -90), "one"));
  ASSERT_TRUE(document.undo());
  ASSERT_TRUE(document.edit(turned(document, -20), "other"));
  EXPECT_FALSE(document.can_redo());
  EXPECT_EQ(document.undo_label(), "other");
}

TEST(Document, SaysWhatAnEditTouches) {
  Document document = opened("builtin:woman");
  Scene scene = document.scene();
  scene.look.shadows = false;
  EXPECT_EQ(*document.edit(scene, "shadows"), Touched::look);
  scene.characters[0].muscles.pop_back();
  EXPECT_EQ(*document.edit(scene, "muscle"), Touched::all);
  EXPECT_EQ(*document.edit(scene, "nothing"), Touched::look);
  EXPECT_EQ(document.undo_label(), "muscle") << "what changes nothing is no edit";
}

TEST(Document, AnEditThatFailsChangesNothing) {
  Document document = opened();
  const Scene before = document.scene();
  const Vec3 rest = hand(document);
  Scene scene = before;
  scene.characters[0].keys["noSuchJoint"] = Keyed<Vec3>::constant(Vec3(1.0));
  const auto failed = document.edit(scene, "wrong");
  ASSERT_FALSE(failed);
  EXPECT_NE(failed.error().message.find("noSuchJoint"), std::string::npos);
  scene = before;
  scene.characters.push_back(scene.characters[0]);
  scene.characters[1].model = "there/is/no.glb";
  EXPECT_FALSE(document.edit(scene, "wrong too"));
  EXPECT_EQ(document.scene(), before);
  EXPECT_EQ(hand(document), rest) << "models that were lent came back";
  EXPECT_FALSE(document.can_undo());
}

TEST(Document, AnEditThatCannotBeShownIsAsIfItHadNotBeen) {
  Document document = opened();
  ASSERT_TRUE(document.edit(turned(document, -90), "one"));
  ASSERT_TRUE(document.edit(turned(document, -80), "two"));
  ASSERT_TRUE(document.undo());
  const Scene before = document.scene();
  ASSERT_TRUE(document.edit(turned(document, -20), "other"));
  ASSERT_TRUE(document.take_back());
  EXPECT_EQ(document.scene(), before);
  EXPECT_EQ(document.undo_label(), "one");
  EXPECT_EQ(document.redo_label(), "two") << "what could be done again still can";
  ASSERT_TRUE(document.redo());
  ASSERT_TRUE(document.take_back());
  EXPECT_EQ(document.scene(), before);
  // Of a slider the last step alone.
  ASSERT_TRUE(document.edit(turned(document, -10), "turn", "elbow"));
  ASSERT_TRUE(document.edit(turned(document, -5), "turn", "elbow"));
  ASSERT_TRUE(document.take_back());
  EXPECT_DOUBLE_EQ(joint_degrees(document.scene().characters[0], "leftLowerArm", 0).y, -10.0);
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(document.scene(), before);
  document.set_options(Deformer::rigid, BulgeMode::off, 0.5);
  ASSERT_TRUE(document.take_back());
  EXPECT_EQ(document.options().deformer, Deformer::ssd);
  EXPECT_DOUBLE_EQ(document.stage().strength, 1.0);
}

TEST(Document, TheCameraIsSavedButNotUndone) {
  Document document = opened();
  ASSERT_TRUE(document.edit(turned(document, -90), "turn"));
  Camera camera;
  camera.orbit = Keyed<double>::constant(30.0);
  document.move_camera(camera);
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(document.scene().camera, camera);
}

TEST(Document, ASavedSceneOpensAsTheSame) {
  const std::string file = ::testing::TempDir() + "document_test_scene.json";
  Document document = opened("builtin:woman");
  ASSERT_TRUE(document.edit(turned(document, -100, 0), "turn"));
  Camera camera;
  camera.elevation = 12.5;
  camera.target = Keyed<Vec3>::constant({0, 1, 0});
  camera.distance = Keyed<double>::constant(3.0);
  document.move_camera(camera);
  ASSERT_TRUE(document.save(file));
  EXPECT_FALSE(document.is_changed());
  const Document again = opened(file);
  EXPECT_EQ(again.scene(), document.scene());
  EXPECT_EQ(hand(again), hand(document));
  ASSERT_TRUE(document.undo());
  EXPECT_TRUE(document.is_changed()) << "what is saved is the turned arm";
  EXPECT_FALSE(document.save("/no/such/folder/scene.json"));
}

TEST(JointKeys, RestingJointsHaveOneValueMovingOnesKeys) {
  Character character;
  set_joint_degrees(character, "a", 5, {1, 0, 0});
  set_joint_degrees(character, "a", 9, {2, 0, 0});
  EXPECT_EQ(character.keys["a"].keys.size(), 1u) << "a joint that rests is turned as a whole";
  add_joint_key(character, "a", 12);
  set_joint_degrees(character, "a", 12, {8, 0, 0});
  set_joint_degrees(character, "a", 6, {4, 0, 0});
  ASSERT_EQ(character.keys["a"].keys.size(), 3u);
  EXPECT_DOUBLE_EQ(joint_degrees(character, "a", 9).x, 6.0);
  EXPECT_EQ(joint_degrees(character, "b", 9), Vec3(0.0));
  remove_joint_key(character, "a", 6);
  EXPECT_EQ(character.keys["a"].keys.size(), 2u);
  remove_joint_key(character, "a", 7);
  EXPECT_EQ(character.keys["a"].keys.size(), 2u) << "there is none";
  remove_joint_key(character, "a", 12);
  remove_joint_key(character, "a", 0);
  EXPECT_TRUE(character.keys.empty());
}

TEST(RenderCommand, IsOneThatAShellTakes) {
  Document document = opened();
  EXPECT_EQ(render_command(document, "scene.json", 3, 640, 480),
            "sinew render scene.json --frame 3 --size 640x480 -o picture.png");
  document.set_options(Deformer::rigid, BulgeMode::off, 0.5);
  EXPECT_EQ(
      render_command(document, "my scene's.json", 0, 640, 480),
      "sinew render 'my scene'\\''s.json' --deformer rigid --bulge off --strength 0.5 --frame 0 --size 640x480 -o "
      "picture.png");
}

}  // namespace
}  // namespace sinew::test
