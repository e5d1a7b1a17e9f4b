/// Files that cannot be written and runs that are stopped: nothing half-written is left under any name.

#include <sys/mount.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "tests/support/program.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

class Output : public ProgramTest {
 protected:
  void expect_not_written(const Arguments& arguments) const {
    const std::set<std::string> before = names();
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 7) << result;
    EXPECT_NE(result.err.find("error: "), std::string::npos) << result;
    EXPECT_EQ(names(), before) << "something is left" << result;
  }
};

/// Every picture is whole and nothing else is there.
void expect_whole_pictures(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    EXPECT_EQ(entry.path().extension(), ".png") << entry.path();
    const auto bytes = read_file(entry.path());
    ASSERT_TRUE(bytes) << bytes.error().message;
    EXPECT_TRUE(decode_png(*bytes)) << entry.path() << " is not whole";
  }
}

std::size_t file_count(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST_F(Output, MissingFolder) {
  expect_not_written({"render", arm_scene, "-o", "absent/x.png"});
  expect_not_written({"render", arm_scene, "--frames", "0-3", "-o", "absent/x_####.png"});
  for (const char* name : {"absent/x.obj", "absent/x.ply", "absent/x.glb"})
    expect_not_written({"export", arm_scene, "-o", name});
  expect_not_written({"export", arm_scene, "--rig", "-o", "absent/x.glb"});
}

TEST_F(Output, FolderThatTakesNoFiles) {
  // Not even the superuser can create a file there.
  expect_not_written({"render", arm_scene, "-o", "/proc/x.png"});
  expect_not_written({"export", arm_scene, "-o", "/proc/x.obj"});
  if (geteuid() == 0) return;
  fs::create_directory(path("closed"));
  fs::permissions(path("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  expect_not_written({"render", arm_scene, "-o", "closed/x.png"});
  expect_not_written({"export", arm_scene, "-o", "closed/x.obj"});
}

TEST_F(Output, NameOfAFolder) {
  fs::create_directory(path("folder.png"));
  fs::create_directory(path("folder.obj"));
  expect_not_written({"render", arm_scene, "-o", "folder.png"});
  expect_not_written({"export", arm_scene, "-o", "folder.obj"});
}

// Devices are reached by links in the test's folder: a program that replaced what it should write to would replace the
// link, and not, run as root, the machine's own device.
TEST_F(Output, DeviceThatIsFull) {
  ASSERT_TRUE(fs::is_character_file("/dev/full")) << "this machine's /dev/full is no device";
  for (const char* ending : {"png", "obj", "ply", "glb"})
    fs::create_symlink("/dev/full", path(std::string("full.") + ending));
  expect_not_written({"render", arm_scene, "-o", "full.png"});
  for (const char* name : {"full.obj", "full.ply", "full.glb"}) expect_not_written({"export", arm_scene, "-o", name});
  expect_not_written({"export", arm_scene, "--rig", "-o", "full.glb"});
  for (const char* ending : {"png", "obj", "ply", "glb"})
    EXPECT_TRUE(fs::is_symlink(path(std::string("full.") + ending))) << "the device was replaced: " << ending;
}

TEST_F(Output, ReportThatCannotBePrinted) {
  const ProgramResult result = run({"info", arm(), "--json"}, {.output = "/dev/full"});
  EXPECT_EQ(result.exit_code, 7) << result;
}

TEST_F(Output, NullDeviceTakesEverything) {
  ASSERT_TRUE(fs::is_character_file("/dev/null")) << "this machine's /dev/null is no device";
  fs::create_symlink("/dev/null", path("null.png"));
  const ProgramResult result = run({"render", arm_scene, "--size", "64x64", "-o", "null.png"});
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_TRUE(fs::is_symlink(path("null.png"))) << "the device was replaced";
}

/// A disk of so many bytes, mounted while it lives.
class SmallDisk {
 public:
  SmallDisk(const fs::path& folder, const std::string& size) : folder_(folder) {
    fs::create_directory(folder);
    mounted_ = mount("tmpfs", folder.c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
  }
  ~SmallDisk() {
    if (mounted_) umount(folder_.c_str());
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  bool mounted() const { return mounted_; }

 private:
  fs::path folder_;
  bool mounted_ = false;
};

TEST_F(Output, FullDisk) {
  const SmallDisk disk(path("disk"), "128k");
  if (!disk.mounted()) GTEST_SKIP() << "SKIPPED: needs the right to mount a tmpfs (run as root)";
  // What stood there before stays.
  write("disk/x.png", "old");
  write("disk/x.glb", "old");
  expect_not_written({"render", arm_scene, "--size", "1920x1080", "-o", "disk/x.png"});
  expect_not_written({"export", arm_scene, "--frames", "0-9", "-o", "disk/x.glb"});
  expect_not_written({"export", arm_scene, "-o", "disk/new.obj"});
  EXPECT_EQ(read("disk/x.png"), read("disk/x.glb"));
  EXPECT_EQ(read("disk/x.png").size(), 3u);
  fs::remove(path("disk/x.png"));
  fs::remove(path("disk/x.glb"));

  // Some pictures fit, the rest do not: those that are there are whole.
  const ProgramResult result =
      run({"render", arm_scene, "--frames", "0-47", "--size", "320x180", "-o", "disk/x_####.png"});
  EXPECT_EQ(result.exit_code, 6) << result;
  EXPECT_GT(file_count(path("disk")), 0u);
  EXPECT_LT(file_count(path("disk")), 48u);
  expect_whole_pictures(path("disk"));
}

/// A run that would take minutes and how it is seen to be under way.
struct LongRun {
  Arguments arguments;
  std::size_t files;  ///< in the folder before the signal
};

class Stopped : public Output {
 protected:
  /// Sends the signal once so many files are there (or some time has passed where the run writes only at its end).
  ProgramResult stop(const LongRun& run, int signal) const {
    fs::create_directory(path("out"));
    RunningProgram program(run.arguments, {.folder = path("out")});
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (file_count(path("out")) < run.files && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    // Long enough to be past the start, short enough that none of these runs is at its end.
    std::this_thread::sleep_for(std::chrono::milliseconds(run.files == 0 ? 700 : 30));
    program.send(signal);
    return program.finish();
  }
};

const Arguments long_sequence{"render", arm_scene, "--frames", "0-99999", "--size", "320x180", "-o", "x_#####.png"};

TEST_F(Stopped, ByInterruptEveryPictureIsWhole) {
  const ProgramResult result = stop({long_sequence, 5}, SIGINT);
  EXPECT_EQ(result.exit_code, 130) << result;
  EXPECT_GE(file_count(path("out")), 5u);
  expect_whole_pictures(path("out"));
}

TEST_F(Stopped, ByTerminationEveryPictureIsWhole) {
  const ProgramResult result = stop({long_sequence, 5}, SIGTERM);
  EXPECT_EQ(result.exit_code, 143) << result;
  EXPECT_GE(file_count(path("out")), 5u);
  expect_whole_pictures(path("out"));
}

TEST_F(Stopped, MeshesAreWhole) {
  EXPECT_EQ(stop({{"export", arm_scene, "--frames", "0-99999", "-o", "x_#####.ply"}, 5}, SIGINT).exit_code, 130);
  const std::set<std::string> files = names();
  ASSERT_GT(files.size(), 5u);
  std::set<std::uintmax_t> sizes;
  for (const auto& entry : fs::directory_iterator(path("out"))) {
    EXPECT_EQ(entry.path().extension(), ".ply");
    sizes.insert(entry.file_size());
  }
  EXPECT_EQ(sizes.size(), 1u) << "one mesh is shorter than another";
}

TEST_F(Stopped, AFileThatIsWrittenAtTheEndIsNotThere) {
  EXPECT_EQ(stop({{"export", arm_scene, "--frames", "0-99999", "-o", "x.glb"}, 0}, SIGTERM).exit_code, 143);
  EXPECT_EQ(file_count(path("out")), 0u);
}

TEST_F(Stopped, ChecksAndMeasurementsStopToo) {
  for (const Arguments& arguments : {Arguments{"parity", arm_scene, "--frames", "0-99999"},
                                     Arguments{"bench", arm_scene, "--frames-timed", "99999"}}) {
    fs::remove_all(path("out"));
    const ProgramResult result = stop({arguments, 0}, SIGINT);
    EXPECT_EQ(result.exit_code, 130) << result;
    EXPECT_EQ(result.out, "") << result;
  }
}

}  // namespace
}  // namespace sinew::test
