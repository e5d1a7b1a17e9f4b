/// `sinew view` in a real window, on an X server that needs no screen.

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <thread>

#include "engine/core/files.h"
#include "tests/support/assets.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

using namespace std::chrono_literals;

bool has_program(const char* name) {
  return std::system(fmt::format("command -v {} > /dev/null 2>&1", name).c_str()) == 0;
}

/// An X server of its own, ended with the test.
class XServer {
 public:
  XServer() {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return;
    server_ = fork();
    if (server_ == 0) {
      close(ends[0]);
      const std::string fd = std::to_string(ends[1]);
      freopen("/dev/null", "w", stderr);
      execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-screen", "0", "1280x720x24", "-nolisten", "tcp", nullptr);
      _exit(127);
    }
    close(ends[1]);
    std::string number;
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
    close(ends[0]);
    if (!number.empty()) display = ":" + number;
  }
  ~XServer() {
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
  }

  std::string display;  ///< ":3"; empty where the server did not start

 private:
  pid_t server_ = -1;
};

class View : public ProgramTest {
 protected:
  void SetUp() override {
    for (const char* name : {"Xvfb", "xdotool"})
      if (!has_program(name)) {
        if (assets_required()) FAIL() << "SINEW_REQUIRE_ASSETS is 1, but " << name << " is missing";
        GTEST_SKIP() << "SKIPPED: " << name << " is missing";
      }
    ASSERT_FALSE(server_.display.empty()) << "Xvfb does not start";
  }

  ProgramOptions in_window() const {
    ProgramOptions options;
    options.environment["DISPLAY"] = server_.display;
    options.environment["WAYLAND_DISPLAY"] = std::nullopt;
    options.folder = path("");
    return options;
  }
  void act(const std::string& words) const {
    EXPECT_EQ(std::system(fmt::format("DISPLAY={} xdotool {} > /dev/null 2>&1", server_.display, words).c_str()), 0)
        << words;
  }
  /// Waits until the file is there and whole.
  bool appears(const std::string& name) const {
    for (int i = 0; i < 300; ++i) {
      if (std::filesystem::exists(path(name))) return true;
      std::this_thread::sleep_for(100ms);
    }
    return false;
  }
  void wait_for_window() const {
    act("search --sync --onlyvisible --name Sinew");
    std::this_thread::sleep_for(1s);
  }

 private:
  XServer server_;
};

TEST_F(View, ShowsFramesAndEnds) {
  const ProgramResult result = run_program(
      {"view", arm_scene, "--frames", "12", "--uncapped", "--json", "--validate", "--size", "640x360"}, in_window());
  ASSERT_EQ(result.exit_code, 0) << result;
  const nlohmann::json report = json_of(result);
  EXPECT_EQ(report.at("frames"), 12);
  EXPECT_EQ(report.at("size"), (nlohmann::json{640, 360}));
  EXPECT_GT(report.at("fps").get<double>(), 0.0);
}

// The picture that the window has is the one that render makes of the saved scene.
// What is saved and photographed is what render makes of the saved scene, and an edit that was undone is not in it.
TEST_F(View, WhatIsEditedAndSavedIsWhatRenderMakes) {
  std::filesystem::copy_file(arm_scene, path("arm.json"));
  const Bytes before = read("arm.json");
  RunningProgram program({"view", "arm.json", "--size", "640x360", "--validate"}, in_window());
  wait_for_window();
  act("mousemove 320 120");
  act("key 5");
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
