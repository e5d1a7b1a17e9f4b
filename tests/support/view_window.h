#pragma once
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

using namespace std::chrono_literals;

inline bool has_program(const char* name) {
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
      const std::string folder = folder_.path().string();
      execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-screen", "0", "1280x720x24", "-nolisten", "tcp", "-nocursor",
             "-noreset", "-fbdir", folder.c_str(), nullptr);
      _exit(127);
    }
    close(ends[1]);
    std::string number;
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
    close(ends[0]);
    if (!number.empty()) display = ":" + number;
  }
  ~XServer() { stop(); }
  /// Every window loses its display.
  void stop() {
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
    server_ = -1;
  }

  std::string display;  ///< ":3"; empty where the server did not start

  /// What a part of the screen shows: rows of red, green, blue, opaque, as DecodedPng::rgba. Empty where the screen is
  /// not as it was asked for.
  std::vector<std::uint8_t> pixels(int left, int top, int width, int height) const {
    // The server's own file is an XWD dump: a head of big-endian words, a table of colours, blue-first pixels.
    const auto file = read_file(folder_.path() / "Xvfb_screen0");
    if (!file) return {};
    const auto word = [&](std::size_t index) {
      std::uint32_t value = 0;
      for (std::size_t i = 0; i < 4; ++i) value = value << 8 | (*file)[4 * index + i];
      return value;
    };
    const std::size_t colour = 12, start = word(0) + colour * word(19), row_bytes = word(12);
    if (word(11) != 32 || left + width > static_cast<int>(word(4)) || top + height > static_cast<int>(word(5)))
      return {};
    std::vector<std::uint8_t> rgba;
    for (int y = top; y < top + height; ++y)
      for (int x = left; x < left + width; ++x) {
        const std::uint8_t* at =
            file->data() + start + row_bytes * static_cast<std::size_t>(y) + 4 * static_cast<std::size_t>(x);
        rgba.insert(rgba.end(), {at[2], at[1], at[0], 255});
      }
    return rgba;
  }

 private:
  TemporaryFolder folder_;  ///< of the screen's pixels
  pid_t server_ = -1;
};

class View : public ProgramTest {
 protected:
  void SetUp() override {
    for (const char* name : {"Xvfb", "xdotool", "xrdb"})
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
    options.environment["XDG_CONFIG_HOME"] = path("config");
    options.folder = path("");
    return options;
  }
  /// The same, for the program as developers build it, which fails where memory was lost.
  ProgramOptions in_checked_window() const {
    ProgramOptions options = in_window();
    options.program = SINEW_CHECKED_PROGRAM;
    options.environment["LSAN_OPTIONS"] =
        fmt::format("print_suppressions=0:suppressions={}/tests/support/leaks.supp", SINEW_SOURCE_DIR);
    return options;
  }
  /// Skips the test, or fails it where nothing may be missing, where LeakSanitizer does not work: under a debugger, or
  /// in a container that forbids it to look. Memory that is lost on purpose tells.
  void find_leaks_or_skip() const {
    ProgramOptions options = in_checked_window();
    options.environment["SINEW_LOSE_MEMORY"] = "1";
    const ProgramResult lost = run_program({"--version"}, options);
    if (lost.err.find("detected memory leaks") != std::string::npos) return;
    if (assets_required()) FAIL() << "SINEW_REQUIRE_ASSETS is 1, but lost memory is not found" << lost;
    GTEST_SKIP() << "SKIPPED: LeakSanitizer does not work here" << lost;
  }
  void act(const std::string& words) const {
    EXPECT_EQ(std::system(fmt::format("DISPLAY={} xdotool {} > /dev/null 2>&1", server_.display, words).c_str()), 0)
        << words;
  }
  const std::string& display() const { return server_.display; }
  XServer& screen() { return server_; }
  void press(const std::string& key) const {
    act("key " + key);
    std::this_thread::sleep_for(400ms);
  }
  /// Closes the window and gives how the program ended.
  ProgramResult quit(RunningProgram& program) const {
    press("Escape");
    press("ctrl+q");
    press("ctrl+q");  // whatever is not saved
    return program.finish();
  }
  /// Waits until the file is there and whole.
  bool appears(const std::string& name) const {
    for (int i = 0; i < 300; ++i) {
      if (std::filesystem::exists(path(name))) return true;
      std::this_thread::sleep_for(100ms);
    }
    return false;
  }
  /// Presses the left button at one point, goes to another and lets go.
  void drag(int from_x, int from_y, int to_x, int to_y) const {
    act(fmt::format("mousemove {} {}", from_x, from_y));
    std::this_thread::sleep_for(300ms);
    act("mousedown 1");
    constexpr int steps = 6;
    for (int i = 1; i <= steps; ++i) {
      act(fmt::format("mousemove {} {}", from_x + (to_x - from_x) * i / steps, from_y + (to_y - from_y) * i / steps));
      std::this_thread::sleep_for(100ms);
    }
    act("mouseup 1");
    std::this_thread::sleep_for(800ms);
  }
  void click(int x, int y) const {
    act(fmt::format("mousemove {} {}", x, y));
    std::this_thread::sleep_for(300ms);
    act("click 1");
    std::this_thread::sleep_for(1500ms);
  }
  void wait_for_window() const {
    act("search --sync --onlyvisible --name Sinew");
    std::this_thread::sleep_for(1s);
  }

 private:
  XServer server_;
};

}  // namespace sinew::test
