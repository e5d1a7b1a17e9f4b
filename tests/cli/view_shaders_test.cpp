/// Shaders that are edited while the window is open, in the program as developers build it.

#include "tests/support/view_window.h"

namespace sinew::test {
namespace {

class ViewShaders : public View {
 protected:
  void SetUp() override {
    View::SetUp();
    if (HasFatalFailure() || IsSkipped()) return;
    find_leaks_or_skip();
    if (HasFatalFailure() || IsSkipped()) return;
    std::filesystem::copy_file(arm_scene, path("arm.json"));
    std::filesystem::copy(std::string(SINEW_SOURCE_DIR) + "/shaders", path("shaders"));
  }
  /// Puts `more` before the end of the surface's main().
  void edit_surface(const std::string& more) const {
    const Bytes bytes = read("shaders/surface.frag");
    std::string text(bytes.begin(), bytes.end());
    text.insert(text.rfind('}'), more + "\n");
    write("shaders/surface.frag", text);
  }
  /// Of the whole screen, as red as can be.
  int red_pixels() const {
    const std::vector<std::uint8_t> rgba = screen().pixels(0, 0, 1280, 720);
    EXPECT_FALSE(rgba.empty());
    int count = 0;
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4)
      count += rgba[i] == 255 && rgba[i + 1] == 0 && rgba[i + 2] == 0;
    return count;
  }
  static bool comes_to_say(const RunningProgram& program, const std::string& words, int times = 1) {
    for (int i = 0; i < 200; ++i) {
      const std::string said = program.said();
      int found = 0;
      for (std::size_t at = 0; (at = said.find(words, at)) != std::string::npos; at += words.size()) ++found;
      if (found >= times) {
        std::this_thread::sleep_for(500ms);  // until it is drawn
        return true;
      }
      std::this_thread::sleep_for(100ms);
    }
    return false;
  }
  Bytes photo() const {
    std::filesystem::remove(path("arm_0000.png"));
    press("p");
    EXPECT_TRUE(appears("arm_0000.png"));
    std::this_thread::sleep_for(500ms);
    return read("arm_0000.png");
  }
};

TEST_F(ViewShaders, AreShownAnewAndTheOldOnesGoOnWhereTheyDoNotCompile) {
  constexpr int most_of_the_arm = 1000;
  RunningProgram program({"view", "arm.json", "--size", "1280x720", "--shaders", path("shaders"), "--validate"},
                         in_checked_window());
  wait_for_window();
  const Bytes before = photo();
  EXPECT_EQ(red_pixels(), 0);

  edit_surface("  colour = vec4(1.0, 0.0, 0.0, 1.0);");
  ASSERT_TRUE(comes_to_say(program, "the shaders are compiled anew")) << program.said();
  EXPECT_GT(red_pixels(), most_of_the_arm);
  const Bytes in_red = photo();
  EXPECT_NE(in_red, before);

  edit_surface("  nonsense = 1.0;");
  ASSERT_TRUE(comes_to_say(program, "surface.frag:")) << program.said();
  EXPECT_NE(program.said().find("'nonsense' : undeclared identifier"), std::string::npos) << program.said();
  EXPECT_GT(red_pixels(), most_of_the_arm) << "the last that compiled is still shown";
  EXPECT_EQ(photo(), in_red);

  std::filesystem::copy_file(std::string(SINEW_SOURCE_DIR) + "/shaders/surface.frag", path("shaders/surface.frag"),
                             std::filesystem::copy_options::overwrite_existing);
  ASSERT_TRUE(comes_to_say(program, "the shaders are compiled anew", 2)) << program.said();
  EXPECT_EQ(red_pixels(), 0);
  EXPECT_EQ(photo(), before);
  const ProgramResult result = quit(program);
  EXPECT_EQ(result.exit_code, 0) << result;
}

}  // namespace
}  // namespace sinew::test
