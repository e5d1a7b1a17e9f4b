#include "engine/view/edit_work.h"

#include <thread>

#include <gtest/gtest.h>

#include "engine/view/face_edit.h"
#include "tests/view/made_up_clip.h"
#include "tests/view/opened_document.h"

namespace sinew::test {
namespace {

/// Waits for what is being made.
void finish(EditWork& work, Document& document) {
  while (work.is_busy()) {
    const auto done = work.finish(document);
    if (done) {
      ASSERT_TRUE(done->touched) << done->touched.error().message;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

TEST(EditWork, AgesMergeIntoOneEditAndUndoNeedsNoDrawing) {
  Document document = opened("builtin:head");
  const Scene before = document.scene();
  const Vec3 adult = document.stage().characters[0].mesh.positions[100];
  EditWork work;
  for (const double age : {0.2, 0.4, 0.6, 0.8}) {
    Scene scene = document.scene();
    set_head_age(scene.characters[0], 0.0, age);
    ASSERT_TRUE(work.take(document, scene, "age", "age"));
    EXPECT_EQ(work.wanted_head(0)->age.value_at(0.0), age);
  }
  work.seal(document);
  finish(work, document);
  EXPECT_EQ(document.scene().characters[0].head->age.value_at(0.0), 0.8) << "the latest";
  EXPECT_NE(document.stage().characters[0].mesh.positions[100], adult);
  EXPECT_FALSE(document.is_merging());
  EXPECT_TRUE(missing_parts(document.stage(), before, document.options()).empty()) << "the first is spare";
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(document.stage().characters[0].mesh.positions[100], adult);
  EXPECT_FALSE(document.can_undo());
}

TEST(EditWork, ASliderThatComesBackLeavesTheHeadThatWas) {
  Document document = opened("builtin:head");
  Scene scene = document.scene();
  set_head_age(scene.characters[0], 0.0, 0.25);
  ASSERT_TRUE(document.edit(scene, "age"));
  const Vec3 before = document.stage().characters[0].mesh.positions[100];
  EditWork work;
  for (const double age : {0.5, 0.25}) {
    set_head_age(scene.characters[0], 0.0, age);
    ASSERT_TRUE(work.take(document, scene, "age", "age"));
  }
  finish(work, document);
  EXPECT_EQ(document.stage().characters[0].mesh.positions[100], before);
}

TEST(EditWork, LeavesOtherEditsAloneAndForgetsWhatIsDropped) {
  Document document = opened("builtin:head");
  EditWork work;
  Scene scene = document.scene();
  set_expression(scene.characters[0], 0.0, Expression::smile, 1.0);
  EXPECT_FALSE(work.take(document, scene, "smile", ""));
  set_skull(scene.characters[0], "round", 0.5);
  ASSERT_TRUE(work.take(document, scene, "skull", ""));
  work.drop();
  finish(work, document);
  EXPECT_FALSE(document.scene().characters[0].head);
  EXPECT_FALSE(document.can_undo());
}

/// A library with two clips, and edits that play them.
class Motions : public testing::Test {
 protected:
  Motions() : folder_(std::filesystem::temp_directory_path() / fmt::format("sinew-edit-work-{}", ::getpid())) {
    std::filesystem::remove_all(folder_);
    MotionLibrary library = std::move(*MotionLibrary::open(file(), true));
    for (const char* name : {"wave", "nod"}) EXPECT_TRUE(library.add(made_up_clip(name, false, 30)));
  }
  ~Motions() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path file() const { return folder_ / "motions.db"; }

  Document woman() const {
    Document document = opened("builtin:woman");
    Scene scene = document.scene();
    scene.library = file();
    EXPECT_TRUE(document.edit(scene, "library"));
    return document;
  }
  static Scene playing(const Document& document, const std::string& clip) {
    Scene scene = document.scene();
    scene.characters[0].motion = MotionUse{.source = LibraryClip{clip}};
    return scene;
  }
  static std::string played(const Document& document) {
    const auto& motion = document.stage().characters[0].motion;
    return motion ? std::get<LibraryClip>(motion->use.source).name : "";
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(Motions, AreMadeBesideOnceAndUndoneAtOnce) {
  Document document = woman();
  EditWork work;
  ASSERT_TRUE(work.take(document, playing(document, "wave"), "wave", ""));
  EXPECT_EQ(played(document), "") << "not yet";
  finish(work, document);
  EXPECT_EQ(played(document), "wave");
  // What plays is not made again, however it is used; nor is what is taken away and put back.
  Scene later = document.scene();
  later.characters[0].motion->start = 10.0;
  EXPECT_FALSE(work.take(document, later, "start", ""));
  EXPECT_FALSE(work.take_undo(document));
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(played(document), "");
  EXPECT_FALSE(work.take_redo(document));
  ASSERT_TRUE(document.redo());
  EXPECT_EQ(played(document), "wave");
}

TEST_F(Motions, TheLastChoiceCountsAndOtherEditsStay) {
  Document document = woman();
  EditWork work;
  ASSERT_TRUE(work.take(document, playing(document, "wave"), "wave", ""));
  ASSERT_FALSE(work.finish(document));
  ASSERT_TRUE(work.take(document, playing(document, "nod"), "nod", ""));
  Scene turned = document.scene();
  set_joint_degrees(turned.characters[0], "leftLowerArm", 0.0, {0, -50, 0});
  EXPECT_FALSE(work.take(document, turned, "turn", "")) << "a joint waits for no motion";
  ASSERT_TRUE(document.edit(turned, "turn"));
  finish(work, document);
  EXPECT_EQ(played(document), "nod");
  EXPECT_DOUBLE_EQ(joint_degrees(document.scene().characters[0], "leftLowerArm", 0).y, -50.0);
  EXPECT_EQ(document.undo_label(), "nod");
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(document.undo_label(), "turn") << "the choice that was changed is no edit";
}

TEST_F(Motions, WhatIsNotShownYetIsWithdrawn) {
  Document document = woman();
  EditWork work;
  ASSERT_TRUE(work.take(document, playing(document, "wave"), "wave", ""));
  ASSERT_FALSE(work.finish(document));
  EXPECT_EQ(work.withdraw(document), "wave");
  finish(work, document);
  EXPECT_EQ(played(document), "");
  EXPECT_EQ(document.undo_label(), "library");
  EXPECT_FALSE(work.withdraw(document));
}

TEST_F(Motions, AnErrorIsSaidAndChangesNothing) {
  Document document = woman();
  EditWork work;
  ASSERT_TRUE(work.take(document, playing(document, "wive"), "wive", ""));
  std::optional<EditWork::Done> done;
  while (!(done = work.finish(document))) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  ASSERT_FALSE(done->touched);
  EXPECT_NE(done->touched.error().message.find("wave"), std::string::npos) << done->touched.error().message;
  EXPECT_FALSE(work.is_busy());
  EXPECT_EQ(document.undo_label(), "library");
}

TEST_F(Motions, AClipThatChangedInTheLibraryIsReadAnew) {
  Document document = woman();
  EditWork work;
  ASSERT_TRUE(work.take(document, playing(document, "wave"), "wave", ""));
  finish(work, document);
  const std::string before = document.stage().characters[0].motion->content_hash;
  EXPECT_TRUE(missing_parts(document.stage(), document.scene(), document.options()).empty())
      << "reading leaves no mark";
  {
    MotionLibrary library = std::move(*MotionLibrary::open(file(), true));
    StoredClip other = made_up_clip("nod", false, 45);
    other.entry.name = "wave";
    ASSERT_TRUE(library.add(other, true));
  }
  EXPECT_FALSE(missing_parts(document.stage(), document.scene(), document.options()).empty());
  Scene later = document.scene();
  later.characters[0].motion->start = 10.0;
  ASSERT_TRUE(work.take(document, later, "start", ""));
  finish(work, document);
  EXPECT_NE(document.stage().characters[0].motion->content_hash, before);
}

TEST(MissingParts, EachModelServesOneCharacter) {
  Document document = opened("builtin:woman");
  Scene two = document.scene();
  two.characters.push_back(two.characters[0]);
  const MissingParts missing = missing_parts(document.stage(), two, document.options());
  ASSERT_EQ(missing.parts.size(), 1u);
  EXPECT_EQ(missing.parts[0].character, 1u);
  TaskWatch watch;
  auto made = make_parts(missing, watch);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_DOUBLE_EQ(watch.share(), 1.0);
  document.lend(std::move(*made));
  EXPECT_TRUE(missing_parts(document.stage(), two, document.options()).empty());
  EXPECT_TRUE(document.edit(two, "twins"));
  watch.cancel();
  const auto stopped = make_parts(missing, watch);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::interrupted);
}

TEST(OpenStage, CountsAndStops) {
  SceneOptions options;
  options.scene = "builtin:woman";
  TaskWatch watch;
  ASSERT_TRUE(open_stage(options, watch));
  EXPECT_DOUBLE_EQ(watch.share(), 1.0);
  watch.cancel();
  const auto stopped = open_stage(options, watch);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::interrupted);
}

}  // namespace
}  // namespace sinew::test
