/// Meshes bound in the window.

#include "tests/support/view_window.h"

namespace sinew::test {
namespace {

class ViewSkin : public View {
 protected:
  void SetUp() override {
    View::SetUp();
    if (HasFatalFailure() || IsSkipped()) return;
    ASSERT_EQ(run({"figure", "--joints", "23", "-o", "figure.glb"}).exit_code, 0);
    ASSERT_EQ(run({"export", "figure.glb", "--by", "cpu", "-o", "bare.obj"}).exit_code, 0);
  }
};

// A mesh without a skin has the panel first, open.
TEST_F(ViewSkin, ABareMeshIsBoundAndOpened) {
  RunningProgram program({"view", "bare.obj", "--size", "1280x720", "--validate"}, in_window());
  wait_for_window();
  click(190, 168);
  act("type --delay 20 figure.glb");
  std::this_thread::sleep_for(500ms);
  click(140, 276);
  ASSERT_TRUE(appears("bare_bound.glb"));
  std::this_thread::sleep_for(4s);
  press("ctrl+s");
  const ProgramResult result = quit(program);
  EXPECT_EQ(result.exit_code, 0) << result;
  ASSERT_EQ(run({"bind", "bare.obj", "figure.glb", "-o", "again.glb"}).exit_code, 0);
  EXPECT_EQ(read("bare_bound.glb"), read("again.glb")) << "the command's own bytes";
  const Bytes saved = read("scene.json");
  const nlohmann::json scene = nlohmann::json::parse(saved.begin(), saved.end());
  EXPECT_NE(scene.at("characters")[0].at("model").dump().find("bare_bound.glb"), std::string::npos) << scene.dump();
}

}  // namespace
}  // namespace sinew::test
