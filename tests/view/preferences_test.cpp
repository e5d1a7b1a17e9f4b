#include "engine/view/preferences.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "engine/core/files.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

class PreferencesFile : public testing::Test {
 protected:
  PreferencesFile() : folder_(fs::temp_directory_path() / fmt::format("sinew-preferences-{}", ::getpid())) {}
  ~PreferencesFile() override { fs::remove_all(folder_); }
  fs::path file() const { return folder_ / "sinew" / "view.json"; }
  void write(const std::string& text) const {
    fs::create_directories(file().parent_path());
    ASSERT_TRUE(write_file(file(), text));
  }

 private:
  fs::path folder_;
};

TEST_F(PreferencesFile, WithoutAFileAreTheUsualOnes) {
  const auto loaded = load_preferences(file());
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(*loaded, Preferences{});
}

TEST_F(PreferencesFile, ComeBackAsTheyWereSaved) {
  Preferences given;
  given.window = {1600, 900};
  given.panels = false;
  given.motion_panel = true;
  given.remember("/some where/\"quoted\".json");
  given.remember("/b/figure.glb");
  ASSERT_TRUE(save_preferences(given, file()));
  const auto back = load_preferences(file());
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(*back, given);
  EXPECT_EQ(back->folder, "/b");
}

TEST_F(PreferencesFile, ABrokenOneIsNamedWithItsPlace) {
  for (const auto& [text, place] : {std::pair{R"({"window": [1280]})", "/window"},
                                    {R"({"window": [1280, "tall"]})", "/window/1"},
                                    {R"({"window": [1280, 1]})", "/window/1"},
                                    {R"({"recent": [3]})", "/recent/0"},
                                    {R"({"pannels": true})", "/pannels"},
                                    {"{\"panels\": tr", "line 1"},
                                    {"[]", "expected"}}) {
    write(text);
    const auto loaded = load_preferences(file());
    ASSERT_FALSE(loaded) << text;
    EXPECT_EQ(loaded.error().kind, ErrorKind::bad_input);
    EXPECT_NE(loaded.error().message.find("view.json"), std::string::npos) << loaded.error().message;
    EXPECT_NE(loaded.error().message.find(place), std::string::npos) << loaded.error().message;
  }
}

TEST_F(PreferencesFile, WhereNoneCanBeWrittenItSaysSo) {
  EXPECT_EQ(save_preferences({}, "/proc/no/view.json").error().kind, ErrorKind::cannot_write);
  EXPECT_EQ(save_preferences({}, "").error().kind, ErrorKind::cannot_write);
}

TEST(RecentFiles, TheLastComesFirstAndOnce) {
  Preferences preferences;
  for (int i = 0; i < 15; ++i) preferences.remember(fmt::format("/folder/{}.json", i));
  ASSERT_EQ(preferences.recent.size(), Preferences::most_recent);
  EXPECT_EQ(preferences.recent.front(), "/folder/14.json");
  preferences.remember("/folder/deep/../10.json");
  EXPECT_EQ(preferences.recent.front(), "/folder/10.json");
  EXPECT_EQ(std::ranges::count(preferences.recent, "/folder/10.json"), 1);
  EXPECT_EQ(preferences.recent.size(), Preferences::most_recent);
}

}  // namespace
}  // namespace sinew::test
