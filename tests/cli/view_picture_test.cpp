/// What the window shows, pixel by pixel: the picture that `render` makes, where the panels leave room for it.

#include "tests/support/view_window.h"

namespace sinew::test {
namespace {

class ViewPicture : public View {
 protected:
  /// Largest difference of any channel between a part of the screen and what render makes of the scene in that size,
  /// when the window has come to rest; 255 where they cannot be compared.
  int difference(const char* frame, int left, int top, int width, int height) {
    const std::string size = fmt::format("{}x{}", width, height);
    if (run({"render", "scene.json", "--frame", frame, "--size", size, "-o", "again.png"}).exit_code != 0) return 255;
    const DecodedPng rendered = picture("again.png");
    int most = 255;
    for (int patience = 20; patience > 0 && most > 0; --patience) {
      const std::vector<std::uint8_t> shown = screen().pixels(left, top, width, height);
      if (shown.size() != rendered.rgba.size()) return 255;
      most = 0;
      for (std::size_t i = 0; i < shown.size(); ++i) most = std::max(most, std::abs(shown[i] - rendered.rgba[i]));
      if (most > 0) std::this_thread::sleep_for(200ms);
    }
    return most;
  }
};

// 300 units on either side and 92 below are the panels'. The same device draws both: no pixel may differ.
TEST_F(ViewPicture, IsThatOfRenderBesideThePanelsAndWithoutThem) {
  write("scene.json", R"({"sinew": 1, "frames": [0, 23], "characters": [{"model": "builtin:woman",
    "keys": {"leftLowerArm": [[0, [0, 0, 0]], [23, [0, -130, 0]]]}}], "camera": {"view": "three-quarter"}})");
  RunningProgram program({"view", "scene.json", "--size", "1280x720", "--validate"}, in_window());
  wait_for_window();
  act("mousemove 20 700");
  std::this_thread::sleep_for(1s);
  EXPECT_EQ(difference("0", 300, 0, 680, 628), 0);
  press("shift+Right");  // ten frames on
  EXPECT_EQ(difference("10", 300, 0, 680, 628), 0);
  EXPECT_GT(difference("0", 300, 0, 680, 628), 32) << "another frame is another picture";
  press("m");  // motions take from below
  std::this_thread::sleep_for(500ms);
  EXPECT_EQ(difference("10", 300, 0, 680, 308), 0);
  press("m");
  press("Tab");
  std::this_thread::sleep_for(500ms);
  EXPECT_EQ(difference("10", 0, 0, 1280, 720), 0);
  const ProgramResult result = quit(program);
  EXPECT_EQ(result.exit_code, 0) << result;
}

// Half as large again: the panels' 300 units are 450 pixels, the bar's 92 are 138.
TEST_F(ViewPicture, IsThatOfRenderOnADenseDisplay) {
  write("scene.json", R"({"sinew": 1, "characters": [{"model": "builtin:woman"}]})");
  ASSERT_EQ(std::system(fmt::format("echo 'Xft.dpi: 144' | DISPLAY={} xrdb -nocpp -merge", display()).c_str()), 0);
  RunningProgram program({"view", "scene.json", "--size", "852x480", "--validate"}, in_window());
  wait_for_window();
  EXPECT_EQ(difference("0", 450, 0, 1278 - 2 * 450, 720 - 138), 0);
  click(955, 68);  // reach

  EXPECT_GT(difference("0", 450, 0, 378, 582), 32) << "handles stand on hands and feet";
  const ProgramResult result = quit(program);
  EXPECT_EQ(result.exit_code, 0) << result;
}

}  // namespace
}  // namespace sinew::test
