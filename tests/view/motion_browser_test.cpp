#include "engine/view/motion_browser.h"

#include <thread>

#include <gtest/gtest.h>

#include "engine/motion/library_edit.h"
#include "tests/motion/made_up_motion.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

StoredClip made_up_clip(const std::string& name, bool fitted, int frames = 90) {
  StoredClip clip;
  clip.entry.name = name;
  clip.entry.tags = {"calm"};
  clip.motion = made_up_motion(name, frames);
  if (!fitted) return clip;
  CurveFitOptions options;
  options.tolerance = 0.2;
  clip.curves = fit_motion(clip.motion, options).clip;
  return clip;
}

constexpr CurveChoice left_arm_z{3, 2};

std::vector<double> sampled(const PiecewisePolynomial& curve) {
  std::vector<double> values;
  for (double t = 0.0; t <= curve.end(); t += 0.01) values.push_back(curve.value(t));
  return values;
}

TEST(ClipEditor, ShowsWhatTheFitLeft) {
  ClipEditor editor(made_up_clip("wave", true));
  for (std::size_t joint = 0; joint < 5; ++joint)
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(editor.largest_residual({joint, axis}), 0.2 + 1e-9) << joint << " " << axis;
      EXPECT_LE(editor.rms_residual({joint, axis}), editor.largest_residual({joint, axis}) + 1e-12);
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

class Browser : public testing::Test {
 protected:
  Browser() : folder_(fs::temp_directory_path() / fmt::format("sinew-browser-{}", ::getpid())) {
    fs::remove_all(folder_);
    MotionLibrary library = std::move(*MotionLibrary::open(file(), true));
    EXPECT_TRUE(library.add(made_up_clip("wave", true)));
    StoredClip nod = made_up_clip("nod", false);
    nod.entry.tags = {"head"};
    nod.entry.emotion = "laugh";
    EXPECT_TRUE(library.add(nod));
  }
  ~Browser() override { fs::remove_all(folder_); }
  fs::path file() const { return folder_ / "motions.db"; }

  static void finish(MotionBrowser& browser) {
    while (!browser.poll()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  static std::vector<std::string> names(const MotionBrowser& browser) {
    std::vector<std::string> found;
    for (const ClipEntry& clip : browser.clips()) found.push_back(clip.name);
    return found;
  }

 private:
  fs::path folder_;
};

TEST_F(Browser, FindsByNameTagAndEmotion) {
  MotionBrowser browser;
  browser.use_library(file());
  EXPECT_EQ(names(browser), (std::vector<std::string>{"nod", "wave"}));
  EXPECT_EQ(browser.tags(), (std::vector<std::string>{"calm", "head"}));
  browser.query.name = "WA";
  browser.refresh();
  EXPECT_EQ(names(browser), std::vector<std::string>{"wave"});
  browser.query = {};
  browser.query.tag = "head";
  browser.refresh();
  EXPECT_EQ(names(browser), std::vector<std::string>{"nod"});
  EXPECT_EQ(browser.tags().size(), 2u) << "tags are the whole library's";
  browser.query = {};
  browser.query.emotion = "anger";
  browser.refresh();
  EXPECT_TRUE(names(browser).empty());
}

TEST_F(Browser, WithoutALibrarySaysWhy) {
  MotionBrowser browser;
  browser.use_library(file().parent_path() / "none.db");
  EXPECT_TRUE(browser.clips().empty());
  EXPECT_NE(browser.trouble().find("none.db"), std::string::npos) << browser.trouble();
}

TEST_F(Browser, FitsBesideAndKeepsTheCurves) {
  MotionBrowser browser;
  browser.use_library(file());
  browser.open("nod");
  finish(browser);
  ASSERT_NE(browser.clip(), nullptr);
  EXPECT_EQ(browser.editor(), nullptr) << "it has no curves yet";
  browser.fit(0.3);
  EXPECT_TRUE(browser.task().running());
  finish(browser);
  ASSERT_NE(browser.editor(), nullptr);
  EXPECT_LE(browser.editor()->largest_residual(left_arm_z), 0.3 + 1e-9);
  const auto kept = std::move(*MotionLibrary::open(file(), false)).load("nod");
  ASSERT_TRUE(kept && kept->curves);
  EXPECT_TRUE(kept->entry.fitted);
}

TEST_F(Browser, AFitThatIsStoppedLeavesTheLibrary) {
  {
    MotionLibrary library = std::move(*MotionLibrary::open(file(), true));
    ASSERT_TRUE(library.add(made_up_clip("long", false, 20000)));
  }
  MotionBrowser browser;
  browser.use_library(file());
  browser.open("long");
  finish(browser);
  browser.fit(0.001);
  browser.cancel();
  finish(browser);
  const auto news = browser.take_news();
  ASSERT_TRUE(news);
  EXPECT_FALSE(news->is_error) << "it was asked for";
  EXPECT_FALSE(std::move(*MotionLibrary::open(file(), false)).load("long")->curves);
}

TEST_F(Browser, SavesEditsAsAClipThatNamesItsParent) {
  MotionBrowser browser;
  browser.use_library(file());
  browser.open("wave");
  finish(browser);
  ASSERT_NE(browser.editor(), nullptr);
  ASSERT_TRUE(browser.editor()->set_key(left_arm_z, 1, 40.0));
  const std::vector<double> shown = sampled(browser.editor()->curve(left_arm_z));
  browser.take_news();
  browser.save_as("big wave");
  finish(browser);
  const auto news = browser.take_news();
  ASSERT_TRUE(news);
  EXPECT_EQ(news->saved, "big wave") << news->message;
  EXPECT_EQ(browser.clip()->entry.name, "big wave");
  const auto made = std::move(*MotionLibrary::open(file(), false)).load("big wave");
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(made->entry.parent, "wave");
  EXPECT_EQ(sampled(made->curves->joints[3].angles[2]), shown);
  // A name that is taken is refused, and nothing is lost.
  ASSERT_TRUE(browser.editor()->set_key(left_arm_z, 1, 10.0));
  browser.save_as("nod");
  finish(browser);
  EXPECT_TRUE(browser.take_news()->is_error);
  EXPECT_TRUE(browser.editor()->is_edited());
}

}  // namespace
}  // namespace sinew::test
