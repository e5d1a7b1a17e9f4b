#include "engine/view/motion_browser.h"

#include <thread>

#include <gtest/gtest.h>

#include "tests/view/made_up_clip.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

constexpr CurveChoice left_arm_z{3, 2};

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
  void open(MotionBrowser& browser, const std::string& clip) const {
    browser.use_library(file());
    browser.open(clip);
    finish(browser);
  }
  StoredClip kept(const std::string& clip) const {
    auto found = std::move(*MotionLibrary::open(file(), false)).load(clip);
    EXPECT_TRUE(found) << found.error().message;
    return std::move(*found);
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
  open(browser, "nod");
  ASSERT_NE(browser.clip(), nullptr);
  EXPECT_EQ(browser.editor(), nullptr) << "it has no curves yet";
  browser.fit(0.3);
  EXPECT_TRUE(browser.task().running());
  finish(browser);
  ASSERT_NE(browser.editor(), nullptr);
  EXPECT_LE(browser.editor()->residual(left_arm_z).largest, 0.3 + 1e-9);
  EXPECT_TRUE(kept("nod").curves);
  EXPECT_TRUE(kept("nod").entry.fitted);
}

TEST_F(Browser, AFitThatIsStoppedLeavesTheLibrary) {
  {
    MotionLibrary library = std::move(*MotionLibrary::open(file(), true));
    ASSERT_TRUE(library.add(made_up_clip("long", false, 20000)));
  }
  MotionBrowser browser;
  open(browser, "long");
  browser.fit(0.001);
  browser.task().cancel();
  finish(browser);
  const auto news = browser.take_news();
  ASSERT_TRUE(news);
  EXPECT_FALSE(news->is_error) << "it was asked for";
  EXPECT_FALSE(kept("long").curves);
}

TEST_F(Browser, SavesEditsAsAClipThatNamesItsParent) {
  MotionBrowser browser;
  open(browser, "wave");
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
  const StoredClip made = kept("big wave");
  EXPECT_EQ(made.entry.parent, "wave");
  EXPECT_EQ(sampled(made.curves->joints[3].angles[2]), shown);
  // A name that is taken is refused, and nothing is lost.
  ASSERT_TRUE(browser.editor()->set_key(left_arm_z, 1, 10.0));
  browser.save_as("nod");
  finish(browser);
  EXPECT_TRUE(browser.take_news()->is_error);
  EXPECT_TRUE(browser.editor()->is_edited());
}

}  // namespace
}  // namespace sinew::test
