/// `sinew view` in a real window, on an X server that needs no screen.

#include "tests/support/view_window.h"

namespace sinew::test {
namespace {

TEST_F(View, ShowsFramesAndEnds) {
  const ProgramResult result = run_program(
      {"view", arm_scene, "--frames", "12", "--uncapped", "--json", "--validate", "--size", "640x360"}, in_window());
  ASSERT_EQ(result.exit_code, 0) << result;
  const nlohmann::json report = json_of(result);
  EXPECT_EQ(report.at("frames"), 12);
  EXPECT_EQ(report.at("size"), (nlohmann::json{640, 360}));
  EXPECT_GT(report.at("fps").get<double>(), 0.0);
}

// What is saved and photographed is what render makes of the saved scene, and an edit that was undone is not in it.
TEST_F(View, WhatIsEditedAndSavedIsWhatRenderMakes) {
  std::filesystem::copy_file(arm_scene, path("arm.json"));
  const Bytes before = read("arm.json");
  RunningProgram program({"view", "arm.json", "--size", "640x360", "--validate"}, in_window());
  wait_for_window();
  act("mousemove 320 120");
  act("key 9");
  act("mousedown 1");
  for (int i = 1; i <= 8; ++i) {
    act(fmt::format("mousemove {} {}", 320 + 5 * i, 120 + i));
    std::this_thread::sleep_for(50ms);
  }
  act("mouseup 1");
  std::this_thread::sleep_for(500ms);
  act("key ctrl+s");
  act("key p");
  ASSERT_TRUE(appears("arm_0000.png")) << "the photo lies beside the scene";
  std::this_thread::sleep_for(500ms);
  act("key ctrl+q");
  const ProgramResult result = program.finish();
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(read("arm.json"), before) << "the camera was turned";
  ASSERT_EQ(run({"render", "arm.json", "--frame", "0", "--size", "640x360", "-o", "again.png"}).exit_code, 0);
  EXPECT_EQ(picture("arm_0000.png").rgba, picture("again.png").rgba);
}

TEST_F(View, WithoutADisplayItSaysWhatWorks) {
  ProgramOptions options = in_window();
  options.environment["DISPLAY"] = std::nullopt;
  const ProgramResult result = run_program({"view", arm_scene}, options);
  EXPECT_EQ(result.exit_code, 4) << result;
  EXPECT_NE(result.err.find("sinew render"), std::string::npos) << result;
}

}  // namespace
}  // namespace sinew::test
