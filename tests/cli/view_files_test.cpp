/// What the viewer keeps: preferences, films, the scene's file as it changes on the disk. And that it rests.

#include <fstream>

#include "tests/support/view_window.h"

namespace sinew::test {
namespace {

class ViewFiles : public View {
 protected:
  void SetUp() override {
    View::SetUp();
    if (HasFatalFailure() || IsSkipped()) return;
    std::filesystem::copy_file(arm_scene, path("arm.json"));
  }
  nlohmann::json file_json(const std::string& name) const {
    const Bytes bytes = read(name);
    return nlohmann::json::parse(bytes.begin(), bytes.end(), nullptr, true, true);
  }
  /// Seconds of all cores that the process has used.
  static double cpu_seconds(pid_t process) {
    std::ifstream stat(fmt::format("/proc/{}/stat", process));
    std::string word;
    for (int i = 0; i < 13; ++i) stat >> word;
    double user = 0.0, system = 0.0;
    stat >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
  }
};

TEST_F(ViewFiles, RestsWhereNothingChanges) {
  RunningProgram program({"view", "arm.json", "--size", "640x360"}, in_window());
  wait_for_window();
  std::this_thread::sleep_for(2s);
  const double before = cpu_seconds(program.id());
  EXPECT_GT(before, 0.0);
  std::this_thread::sleep_for(4s);
  // It wakes twice a second to look at the scene's file: measured below 0.01 s; ten times that is still rest.
  EXPECT_LT(cpu_seconds(program.id()) - before, 0.1);
  EXPECT_EQ(quit(program).exit_code, 0);
}

TEST_F(ViewFiles, ParallelRaysAreSavedAndRenderShowsThem) {
  RunningProgram program({"view", "arm.json", "--size", "640x360", "--validate"}, in_window());
  wait_for_window();
  press("9");
  press("5");
  press("ctrl+s");
  press("p");
  ASSERT_TRUE(appears("arm_0000.png"));
  std::this_thread::sleep_for(500ms);
  const ProgramResult result = quit(program);
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_EQ(file_json("arm.json").at("camera").at("projection"), "orthographic");
  ASSERT_EQ(run({"render", "arm.json", "--frame", "0", "--size", "640x360", "-o", "parallel.png"}).exit_code, 0);
  EXPECT_EQ(picture("arm_0000.png").rgba, picture("parallel.png").rgba);
  nlohmann::json scene = file_json("arm.json");
  scene["camera"].erase("projection");
  write("perspective.json", scene.dump());
  ASSERT_EQ(run({"render", "perspective.json", "--frame", "0", "--size", "640x360", "-o", "other.png"}).exit_code, 0);
  EXPECT_NE(picture("parallel.png").rgba, picture("other.png").rgba);
}

TEST_F(ViewFiles, AsksBeforeEditsAreDropped) {
  const Bytes before = read("arm.json");
  RunningProgram program({"view", "arm.json", "--size", "800x480", "--validate"}, in_window());
  wait_for_window();
  click(27, 205);  // the skeleton is drawn
  press("ctrl+q");
  press("Escape");
  EXPECT_EQ(kill(program.id(), 0), 0) << "cancelled";
  press("ctrl+q");
  press("Return");
  const ProgramResult result = program.finish();
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_EQ(file_json("arm.json").at("look").at("overlay"), nlohmann::json{"skeleton"});

  write("arm.json", std::string(before.begin(), before.end()));
  RunningProgram again({"view", "arm.json", "--size", "800x480", "--validate"}, in_window());
  wait_for_window();
  click(27, 205);
  EXPECT_EQ(quit(again).exit_code, 0);
  EXPECT_EQ(read("arm.json"), before) << "closed twice, it is meant";
}

TEST_F(ViewFiles, EditsOutliveALostDisplayAndASignal) {
  const Bytes before = read("arm.json");
  RunningProgram lost({"view", "arm.json", "--size", "800x480"}, in_window());
  wait_for_window();
  click(27, 205);  // the skeleton is drawn
  kill(lost.id(), SIGTERM);
  ProgramResult result = lost.finish();
  EXPECT_EQ(result.exit_code, 143) << result;
  EXPECT_NE(result.err.find("arm.rescued.json"), std::string::npos) << result;
  EXPECT_EQ(file_json("arm.rescued.json").at("look").at("overlay"), nlohmann::json{"skeleton"});
  std::filesystem::remove(path("arm.rescued.json"));

  RunningProgram program({"view", "arm.json", "--size", "800x480"}, in_window());
  wait_for_window();
  click(27, 205);
  screen().stop();
  result = program.finish();
  EXPECT_EQ(result.exit_code, 5) << result;
  EXPECT_NE(result.err.find("display"), std::string::npos) << result;
  EXPECT_EQ(file_json("arm.rescued.json").at("look").at("overlay"), nlohmann::json{"skeleton"});
  EXPECT_EQ(read("arm.json"), before) << "nobody asked for that";
}

TEST_F(ViewFiles, RecordsTheFilmThatRenderMakes) {
  RunningProgram program({"view", "arm.json", "--size", "320x180", "--validate"}, in_window());
  wait_for_window();
  press("ctrl+r");
  ASSERT_TRUE(appears("arm.mp4"));
  const ProgramResult result = quit(program);
  EXPECT_EQ(result.exit_code, 0) << result;
  ASSERT_EQ(run({"render", "arm.json", "--size", "320x180", "-o", "again.mp4"}).exit_code, 0);
  EXPECT_EQ(read("arm.mp4"), read("again.mp4"));
}

TEST_F(ViewFiles, ClosedWhileRecordingItLeavesNoFilm) {
  RunningProgram program({"view", "builtin:woman", "--size", "1280x720"}, in_window());
  wait_for_window();
  act("key ctrl+r");
  act("key ctrl+q");
  EXPECT_EQ(program.finish().exit_code, 0);
  for (const std::string& name : names()) EXPECT_EQ(name.find(".mp4"), std::string::npos) << name;
}

TEST_F(ViewFiles, WindowPanelsAndRecentFilesAreRemembered) {
  {
    RunningProgram program({"view", "arm.json", "--size", "700x420"}, in_window());
    wait_for_window();
    press("m");
    EXPECT_EQ(quit(program).exit_code, 0);
  }
  const nlohmann::json kept = file_json("config/sinew/view.json");
  EXPECT_EQ(kept.at("window"), (nlohmann::json{700, 420}));
  EXPECT_EQ(kept.at("motion_panel"), true);
  EXPECT_EQ(kept.at("recent"), nlohmann::json{path("arm.json")});
  RunningProgram program({"view"}, in_window());
  wait_for_window();
  press("p");
  ASSERT_TRUE(appears("scene_0000.png"));
  std::this_thread::sleep_for(500ms);
  EXPECT_EQ(quit(program).exit_code, 0);
  EXPECT_EQ(picture("scene_0000.png").width, 700);
  EXPECT_EQ(file_json("config/sinew/view.json").at("recent"), kept.at("recent")) << "the embedded scene is no file";
}

TEST_F(ViewFiles, BrokenPreferencesAreNamedAndLeftAlone) {
  std::filesystem::create_directories(path("config/sinew"));
  write("config/sinew/view.json", R"({"window": "large"})");
  RunningProgram program({"view", "arm.json"}, in_window());
  wait_for_window();
  const ProgramResult result = quit(program);
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.err.find("view.json"), std::string::npos) << result;
  EXPECT_NE(result.err.find("/window"), std::string::npos) << result;
  EXPECT_EQ(file_json("config/sinew/view.json"), (nlohmann::json{{"window", "large"}}));
}

TEST_F(ViewFiles, ASceneThatChangesOnTheDiskIsShownAnew) {
  nlohmann::json scene = file_json("arm.json");
  RunningProgram program({"view", "arm.json", "--size", "320x180"}, in_window());
  wait_for_window();
  scene["look"]["background"] = "#204060";
  write("arm.json", scene.dump());
  std::this_thread::sleep_for(3s);
  press("p");
  ASSERT_TRUE(appears("arm_0000.png"));
  std::this_thread::sleep_for(500ms);
  EXPECT_EQ(quit(program).exit_code, 0);
  ASSERT_EQ(run({"render", "arm.json", "--frame", "0", "--size", "320x180", "-o", "again.png"}).exit_code, 0);
  EXPECT_EQ(picture("arm_0000.png").rgba, picture("again.png").rgba);
}

TEST_F(ViewFiles, AFileOfOthersIsReplacedOnlyWhenAskedTo) {
  write("scene.json", "mine");
  RunningProgram program({"view", "builtin:arm", "--size", "640x360"}, in_window());
  wait_for_window();
  const auto text = [&] {
    const Bytes bytes = read("scene.json");
    return std::string(bytes.begin(), bytes.end());
  };
  press("ctrl+s");
  EXPECT_EQ(text(), "mine") << "it asks";
  press("Escape");
  EXPECT_EQ(text(), "mine") << "no is no";
  press("ctrl+s");
  press("Return");
  EXPECT_TRUE(file_json("scene.json").contains("sinew")) << "yes is yes";
  write("scene.json", text() + " ");
  press("ctrl+s");
  EXPECT_FALSE(text().ends_with(" ")) << "from then on it is the window's own";
  EXPECT_EQ(quit(program).exit_code, 0);
}

}  // namespace
}  // namespace sinew::test
