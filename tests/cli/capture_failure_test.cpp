/// What capture does where files cannot be written, memory is short or too much is asked for: a code and a clear word,
/// and nothing half-written.

#include <sys/mount.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "tests/support/film_reader.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

class CaptureFailure : public ProgramTest {
 protected:
  static void expect_end(const ProgramResult& result, int code, const std::vector<std::string>& words) {
    EXPECT_EQ(result.exit_code, code) << result;
    for (const std::string& word : words)
      EXPECT_NE(result.err.find(word), std::string::npos) << "the message does not say \"" << word << '"' << result;
  }

  /// Starts a run that would take minutes and waits until `names` of its files are there.
  std::unique_ptr<RunningProgram> started(const Arguments& arguments, const fs::path& folder, std::size_t count) const {
    auto program = std::make_unique<RunningProgram>(arguments, ProgramOptions{.folder = path("")});
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    std::error_code ignored;
    while (static_cast<std::size_t>(std::distance(fs::directory_iterator(folder, ignored), fs::directory_iterator())) <
               count &&
           std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return program;
  }

  void expect_no_temporaries(const fs::path& folder) const {
    for (const auto& entry : fs::directory_iterator(folder))
      EXPECT_FALSE(entry.path().filename().string().starts_with('.')) << entry.path();
  }
};

const Arguments long_sequence{"render", arm_scene, "--frames", "0-99999", "--size", "96x54", "-o", "out/x_#####.png"};

TEST_F(CaptureFailure, FolderThatIsMovedAwayEndsTheRun) {
  fs::create_directory(path("out"));
  const auto program = started(long_sequence, path("out"), 5);
  fs::rename(path("out"), path("elsewhere"));
  expect_end(program->finish(), 7, {"out", "has gone"});
  EXPECT_FALSE(fs::exists(path("out"))) << "the program made a folder that nobody asked for";
  for (const auto& entry : fs::directory_iterator(path("elsewhere"))) {
    if (entry.path().filename().string().starts_with('.')) continue;  // cannot be reached by its name any more
    EXPECT_TRUE(decode_png(read_file(entry.path()).value())) << entry.path();
  }
}

TEST_F(CaptureFailure, FolderThatIsDeletedEndsTheRun) {
  fs::create_directory(path("out"));
  const auto program = started(long_sequence, path("out"), 5);
  // Pictures still come while it is emptied.
  std::error_code error;
  do fs::remove_all(path("out"), error);
  while (error);
  expect_end(program->finish(), 7, {"out", "has gone"});
  EXPECT_TRUE(names().empty());
}

TEST_F(CaptureFailure, FilmWhoseFolderIsDeletedEnds) {
  fs::create_directory(path("out"));
  const auto program =
      started({"render", arm_scene, "--frames", "0-99999", "--size", "96x54", "-o", "out/x.mp4"}, path("out"), 1);
  // The first file that is seen is only a trial; half a second later the film is under way.
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  fs::remove_all(path("out"));
  expect_end(program->finish(), 7, {"out/x.mp4"});
  EXPECT_TRUE(names().empty());
}

TEST_F(CaptureFailure, SomeFramesFailAndTheRestAreThere) {
  const auto whole = json({"render", arm_scene, "--frames", "0-47:8", "--size", "320x180", "-o", "x_##.png"});
  std::map<std::string, Bytes> pictures;
  std::vector<std::size_t> sizes;
  for (const std::string& name : names()) {
    pictures[name] = read(name);
    sizes.push_back(pictures[name].size());
    fs::remove(path(name));
  }
  std::sort(sizes.begin(), sizes.end());
  ASSERT_LT(sizes[2], sizes[3]);
  const ProgramResult result = run({"render", arm_scene, "--frames", "0-47:8", "--size", "320x180", "-o", "x_##.png"},
                                   {.largest_file = sizes[2]});
  expect_end(result, 6, {"3 of 6 frames failed", "File too large"});
  EXPECT_EQ(names().size(), 3u);
  for (const auto& [name, bytes] : pictures) {
    EXPECT_EQ(names().contains(name), bytes.size() <= sizes[2]) << name;
    if (bytes.size() <= sizes[2]) {
      EXPECT_EQ(read(name), bytes) << name;
    } else {
      EXPECT_NE(result.err.find(name), std::string::npos) << "it is not said that this one failed: " << name << result;
    }
  }
}

TEST_F(CaptureFailure, AllFramesFailLikeOne) {
  for (const char* output : {"x_##.png", "x.mp4", "x.webm", "x.gif"}) {
    const ProgramResult result =
        run({"render", arm_scene, "--frames", "0-9", "--size", "320x180", "-o", output}, {.largest_file = 1000});
    expect_end(result, 7, {"File too large"});
    EXPECT_TRUE(names().empty()) << output;
  }
}

TEST_F(CaptureFailure, AHopelessRunIsGivenUp) {
  fs::create_directory(path("out"));
  const Arguments many{"render", arm_scene,         "--frames", "0-99999",    "--size", "320x180",
                       "-o",     "out/x_#####.png", "--resume", "--progress", "none"};
  // No picture fits; what is said about them does, since it goes to a file as well.
  const ProgramOptions small_disk{.largest_file = 4000};
  expect_end(run(many, small_disk), 7, {"File too large"});
  EXPECT_EQ(names(), std::set<std::string>{"out"});
  const ProgramResult first = run({"render", arm_scene, "--frames", "0", "--size", "320x180", "-o", "out/x_#####.png"});
  ASSERT_EQ(first.exit_code, 0) << first;
  EXPECT_GT(read("out/x_00000.png").size(), 4000u);
  expect_end(run(many, small_disk), 6, {"the rest was not tried", "x_00001.png", "..."});
  EXPECT_EQ(names(), (std::set<std::string>{"out", "out/x_00000.png"}));
}

TEST_F(CaptureFailure, FullDiskLeavesNoPartOfAFilm) {
  fs::create_directory(path("disk"));
  if (mount("tmpfs", path("disk").c_str(), "tmpfs", 0, "size=64k") != 0)
    GTEST_SKIP() << "SKIPPED: needs the right to mount a tmpfs (run as root)";
  for (const char* film : {"disk/x.mp4", "disk/x.webm", "disk/x.gif"}) {
    const ProgramResult result = run({"render", arm_scene, "--frames", "0-47", "--size", "1280x720", "-o", film});
    expect_end(result, 7, {film, "No space left on device"});
    EXPECT_TRUE(fs::is_empty(path("disk"))) << film;
  }
  umount(path("disk").c_str());
}

TEST_F(CaptureFailure, FilmIsNotWrittenOverADevice) {
  for (const char* device : {"/dev/full", "/dev/null"}) {
    fs::create_symlink(device, path("x.mp4"));
    expect_end(run({"render", arm_scene, "--frames", "0-3", "--size", "64x48", "-o", "x.mp4"}), 7, {"x.mp4", "device"});
    EXPECT_TRUE(fs::is_symlink(path("x.mp4"))) << "the device was replaced";
    fs::remove(path("x.mp4"));
  }
}

TEST_F(CaptureFailure, MoreMemoryThanThereIsEndsWithFive) {
  // A picture of 16384 x 16384 takes a gigabyte, its depth another; the driver alone needs half of one.
  const ProgramResult result =
      run({"render", arm_scene, "--size", "16384x16384", "-o", "x.png"}, {.address_space = std::uint64_t{1} << 30});
  expect_end(result, 5, {"emory"});
  EXPECT_EQ(result.signal, 0) << result;
  EXPECT_TRUE(names().empty());
}

TEST_F(CaptureFailure, MorePixelsThanAnyDeviceTakesAreWrongUsage) {
  for (const char* output : {"x.png", "x_####.png", "x.mp4"})
    expect_end(run({"render", arm_scene, "--size", "100000x100000", "-o", output}), 2,
               {"--size 100000x100000", "16384"});
  EXPECT_TRUE(names().empty());
}

TEST_F(CaptureFailure, NoFramesAtAllAreWrongUsage) {
  for (const char* option : {"--frames", "--frame"})
    for (const char* list : {"", " ", ","})
      expect_end(run({"render", option, list, "-o", "x_####.png"}), 2, {option, "expected a frame"});
  EXPECT_TRUE(names().empty());
}

TEST_F(CaptureFailure, APartWithoutFramesIsDoneAtOnce) {
  std::size_t frames = 0, empty = 0;
  for (int i = 0; i < 4; ++i) {
    const auto report = json({"render", arm_scene, "--frames", "0-1", "--size", "32x18", "--shard",
                              fmt::format("{}/4", i), "-o", "x_####.png"});
    frames += report["frames"].size();
    empty += report["frames"].empty();
  }
  EXPECT_EQ(frames, 2u);
  EXPECT_EQ(empty, 2u);
  EXPECT_EQ(names().size(), 2u);
}

TEST_F(CaptureFailure, OddSizesOfAnMp4ArePaddedAndSaid) {
  const ProgramResult result = run({"render", arm_scene, "--frames", "0-3", "--size", "65x49", "-o", "x.mp4"});
  expect_end(result, 0, {"65 x 49 became 66 x 50", "even"});
  const ReadFilm film = read_film(path("x.mp4"));
  EXPECT_EQ(film.width, 66);
  EXPECT_EQ(film.height, 50);
  EXPECT_EQ(film.frames.size(), 4u);
  // The others take odd sizes as they are.
  EXPECT_EQ(run({"render", arm_scene, "--frames", "0-3", "--size", "65x49", "-o", "x.webm", "--quiet"}).err, "");
  EXPECT_EQ(read_film(path("x.webm")).width, 65);
}

}  // namespace
}  // namespace sinew::test
