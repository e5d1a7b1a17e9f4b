/// The viewer's motion panel, and what random input does to all panels.

#include <cstdlib>
#include <random>

#include "tests/support/view_window.h"

namespace sinew::test {
namespace {

class ViewMotion : public View {};

// Places are those of a window of 1280 x 720: the panel stands above the time bar, its list at the left.
TEST_F(ViewMotion, ADoubleClickedClipIsTheCharactersMotion) {
  ASSERT_EQ(run({"motion", "import", std::string(SINEW_SOURCE_DIR) + "/scenes/laugh.bvh", "--name", "chuckle",
                 "--library", path("motions.db")})
                .exit_code,
            0);
  write("woman.json", R"({"sinew": 1, "frames": [0, 9], "characters": [{"model": "builtin:woman"}]})");
  RunningProgram program({"view", "woman.json", "--size", "1280x720", "--library", path("motions.db"), "--validate"},
                         in_window());
  wait_for_window();
  press("m");
  act("mousemove 380 378 click --repeat 2 --delay 60 1");
  std::this_thread::sleep_for(3s);
  act("mousemove 640 150");
  press("ctrl+s");
  const ProgramResult result = quit(program);
  EXPECT_EQ(result.exit_code, 0) << result;
  const Bytes saved = read("woman.json");
  const nlohmann::json scene = nlohmann::json::parse(saved.begin(), saved.end());
  ASSERT_TRUE(scene.at("characters")[0].contains("motion")) << scene.dump();
  EXPECT_NE(scene.at("characters")[0].at("motion").dump().find("chuckle"), std::string::npos) << scene.dump();
}

/// An arm that bends by 120 degrees until frame 24, its second key in the curve editor.
class ViewCurve : public View {
 protected:
  void SetUp() override {
    View::SetUp();
    if (HasFatalFailure() || IsSkipped()) return;
    write("bend.json", R"({"sinew": 1, "frames": [0, 47], "characters": [{"model": "builtin:woman",
        "keys": {"leftLowerArm": [[0, [0, 0, 0]], [24, [0, -120, 0]]]}}]})");
  }
  void show_curve() const {
    wait_for_window();
    press("m");
    click(1100, 480);  // leftLowerArm
    click(700, 327);   // the scene's keys
    click(723, 354);   // of y
  }
  struct SavedKey {
    double frame = 0.0, degrees = 0.0;
  };
  SavedKey saved() const {
    press("ctrl+s");
    const Bytes bytes = read("bend.json");
    const nlohmann::json scene = nlohmann::json::parse(bytes.begin(), bytes.end());
    const nlohmann::json key = scene.at("characters")[0].at("keys").at("leftLowerArm")[1];
    return {key[0].get<double>(), key[1][1].get<double>()};
  }
};

// What the key is dragged by is one edit. The plot's 230 lines show 144 degrees: 60 of them are 37.6.
TEST_F(ViewCurve, AKeyIsDraggedAndUndone) {
  RunningProgram program({"view", "bend.json", "--size", "1280x720", "--validate"}, in_window());
  show_curve();
  drag(801, 581, 801, 521);
  const SavedKey dragged = saved();
  EXPECT_NEAR(dragged.degrees, -120.0 + 37.6, 6.0);
  EXPECT_EQ(dragged.frame, 24.0) << "straight up it keeps its time";
  press("ctrl+z");
  EXPECT_DOUBLE_EQ(saved().degrees, -120.0);
  const ProgramResult result = quit(program);
  EXPECT_EQ(result.exit_code, 0) << result;
}

// The plot is some 360 pixels wide for 47 frames, so that 60 pixels are about 8 frames.
TEST_F(ViewCurve, AKeyIsDraggedInTime) {
  RunningProgram program({"view", "bend.json", "--size", "1280x720", "--validate"}, in_window());
  show_curve();
  drag(801, 581, 861, 521);
  const SavedKey dragged = saved();
  EXPECT_NEAR(dragged.frame, 32.0, 2.0);
  EXPECT_NEAR(dragged.degrees, -120.0 + 37.6, 6.0);
  press("ctrl+z");
  EXPECT_EQ(saved().frame, 24.0) << "a drag is one edit";
  const ProgramResult result = quit(program);
  EXPECT_EQ(result.exit_code, 0) << result;
}

/// Anything a hand can do to keyboard and mouse, but close the window.
std::string random_input(std::mt19937& random) {
  const auto one_of = [&](std::initializer_list<const char*> words) {
    return std::string(words.begin()[random() % words.size()]);
  };
  const int x = static_cast<int>(random() % 1280), y = static_cast<int>(random() % 720);
  switch (random() % 8) {
    case 0:
      return "key " + one_of({"f",      "k",         "m",      "p",      "1",     "3",     "5",   "7",
                              "9",      "space",     "Tab",    "Left",   "Right", "Home",  "End", "F1",
                              "Escape", "BackSpace", "Return", "Delete", "minus", "period"});
    case 1:
      return "key " + one_of({"ctrl+z", "ctrl+y", "ctrl+s", "ctrl+1", "ctrl+3", "shift+Left", "ctrl+a", "ctrl+r"});
    case 2:
      return fmt::format("mousemove {} {} click {}", x, y, 1 + random() % 5);
    case 3:
      return fmt::format("mousemove {} {} click --repeat 2 --delay 30 1", x, y);
    case 4:
    case 5:
      return fmt::format(
          "mousemove {} {} mousedown {} mousemove_relative -- {} {} mousemove_relative -- {} {} mouseup {}", x, y, 1,
          static_cast<int>(random() % 200) - 100, static_cast<int>(random() % 200) - 100,
          static_cast<int>(random() % 60) - 30, static_cast<int>(random() % 60) - 30, 1);
    case 6:
      return fmt::format("type --delay 5 {}", one_of({"walk", "-12.5", "a.png", "0", "x_###.png", "arm"}));
    default:
      return fmt::format("mousemove {} {}", x, y);
  }
}

// No crash, no message of the validation layer, no memory lost. Seconds of input: SINEW_RANDOM_INPUT, 15 without it.
// Seeds differ where it is long: every minute is another one.
TEST_F(ViewMotion, RandomInputDoesNoHarm) {
  find_leaks_or_skip();
  if (HasFatalFailure() || IsSkipped()) return;
  std::filesystem::copy_file(arm_scene, path("arm.json"));
  const char* asked = std::getenv("SINEW_RANDOM_INPUT");
  const int seconds = std::max(1, asked != nullptr ? std::atoi(asked) : 15);
  ProgramOptions options = in_checked_window();
  options.time_limit = std::chrono::seconds(seconds + 120);
  RunningProgram program({"view", "arm.json", "--size", "1280x720", "--validate", "--library", path("motions.db")},
                         options);
  wait_for_window();
  std::mt19937 random(20240229);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
  std::string done;
  while (std::chrono::steady_clock::now() < end) {
    std::string words;
    for (int i = 0; i < 12; ++i) words += random_input(random) + " ";
    done += words + "\n";
    std::system(fmt::format("DISPLAY={} timeout 20 xdotool {} > /dev/null 2>&1", display(), words).c_str());
    ASSERT_EQ(kill(program.id(), 0), 0) << done;
  }
  // It may be in a text field, with a menu open: those are left first.
  for (int i = 0; i < 3; ++i) act("key Escape");
  act("mousemove 640 100 click 1");
  const ProgramResult result = quit(program);
  EXPECT_EQ(result.exit_code, 0) << result << "\nafter:\n" << done;
}

}  // namespace
}  // namespace sinew::test
