/// Sequences that are taken up again or shared between machines.

#include <csignal>
#include <random>
#include <thread>

#include "tests/support/program.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

class Sequence : public ProgramTest {
 protected:
  nlohmann::json render(const Arguments& more) const {
    Arguments all{"render", arm_scene, "--frames", "0-9", "--size", "64x36", "-o", "x_##.png"};
    all.insert(all.end(), more.begin(), more.end());
    return json(all);
  }
  static std::set<int> frames(const nlohmann::json& report, bool skipped) {
    std::set<int> found;
    for (const auto& frame : report["frames"])
      if (frame["skipped"] == skipped) found.insert(frame["frame"].get<int>());
    return found;
  }
};

TEST_F(Sequence, ResumeMakesOnlyWhatIsMissingOrBroken) {
  const auto whole = render({});
  EXPECT_EQ(frames(whole, false).size(), 10u);
  const Bytes third = read("x_03.png");
  fs::remove(path("x_03.png"));
  fs::resize_file(path("x_05.png"), 100);
  write("x_07.png", "not a picture");
  const auto resumed = render({"--resume"});
  EXPECT_EQ(frames(resumed, false), (std::set<int>{3, 5, 7}));
  EXPECT_EQ(frames(resumed, true), (std::set<int>{0, 1, 2, 4, 6, 8, 9}));
  EXPECT_EQ(read("x_03.png"), third);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(resumed["frames"][i]["sha256"], whole["frames"][i]["sha256"]) << i;
  EXPECT_EQ(names().size(), 10u);
}

TEST_F(Sequence, ResumeDoesNotKeepPicturesOfAnotherRecipe) {
  render({});
  for (const Arguments& changed : {Arguments{"--bulge", "off"}, Arguments{"--shading", "clay"},
                                   Arguments{"--pose", "leftLowerArm=0,-10,0"}, Arguments{"--samples", "4"}}) {
    Arguments more = changed;
    more.emplace_back("--resume");
    EXPECT_EQ(frames(render(more), true).size(), 0u) << changed[0];
    EXPECT_EQ(frames(render(more), false).size(), 0u) << changed[0] << ", once again";
  }
}

TEST_F(Sequence, ResumeTakesUpAStoppedRun) {
  const Arguments words{"render", arm_scene, "--frames", "0-199", "--size", "320x180", "-o", "y_###.png"};
  {
    RunningProgram program(words, {.folder = fs::path(path("")).parent_path()});
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (names().size() < 5 && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    program.send(SIGTERM);
    EXPECT_EQ(program.finish().exit_code, 143);
  }
  const std::size_t made = names().size();
  Arguments more = words;
  more.emplace_back("--resume");
  const auto report = json(more);
  EXPECT_EQ(frames(report, true).size(), made);
  EXPECT_EQ(frames(report, false).size(), 200 - made);
  EXPECT_EQ(names().size(), 200u);
}

/// Every picture that has its final name is whole; the number of them.
std::size_t whole_pictures(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename().string().starts_with('.')) continue;
    ++count;
    const auto bytes = read_file(entry.path());
    EXPECT_TRUE(bytes) << bytes.error().message;
    EXPECT_TRUE(bytes && decode_png(*bytes)) << entry.path() << " is not whole";
  }
  return count;
}

TEST_F(Sequence, KilledTenTimesItIsTheSameInTheEnd) {
  constexpr int frames = 600, kills = 10;
  const auto words = [&](const char* folder, bool resume) {
    Arguments all{"render", arm_scene, "--frames", fmt::format("0-{}", frames - 1),
                  "--size", "96x54",   "-o",       std::string(folder) + "/x_####.png"};
    if (resume) all.emplace_back("--resume");
    return all;
  };
  fs::create_directory(path("whole"));
  fs::create_directory(path("killed"));
  const ProgramResult whole = run(words("whole", false));
  ASSERT_EQ(whole.exit_code, 0) << whole;

  std::mt19937 random(20260101);
  std::size_t made = 0;
  for (int i = 0; i < kills; ++i) {
    const std::size_t before = whole_pictures(path("killed"));
    RunningProgram program(words("killed", true), {.folder = path("")});
    // Past the start, so that the blow falls on work and not on a program that only begins.
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (whole_pictures(path("killed")) <= before && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 60'000));
    program.send(SIGKILL);
    EXPECT_EQ(program.finish().signal, SIGKILL) << "it had come to its end before kill " << i;
    made = whole_pictures(path("killed"));
    EXPECT_GT(made, before) << "kill " << i;
  }
  EXPECT_LT(made, std::size_t{frames});
  // What a blow between creating and renaming leaves, whether or not one of these ten fell there.
  write("killed/.x_0001.png.12-3.part", "half");
  write("killed/.y_0001.png.12-3.part", "somebody else's");

  const ProgramResult resumed = run(words("killed", true));
  ASSERT_EQ(resumed.exit_code, 0) << resumed;
  EXPECT_TRUE(fs::remove(path("killed/.y_0001.png.12-3.part"))) << "another output's temporary was taken away";
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(path("killed"))) {
    ++files;
    const std::string name = entry.path().filename().string();
    ASSERT_TRUE(fs::exists(path("whole/" + name))) << name << " is left over";
    EXPECT_EQ(read("killed/" + name), read("whole/" + name)) << name;
  }
  EXPECT_EQ(files, std::size_t{frames});
}

TEST_F(Sequence, FilmThatWasKilledLeavesNothingToTheNext) {
  write("f.mp4", "an older film");
  for (int i = 0; i < 2; ++i) {
    RunningProgram program({"render", arm_scene, "--frames", "0-9999", "--size", "96x54", "-o", "f.mp4"},
                           {.folder = path("")});
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (names().size() < 2 && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    program.send(SIGKILL);
    EXPECT_EQ(program.finish().signal, SIGKILL);
    EXPECT_EQ(names().size(), 2u) << "the second run takes the first one's away";
    EXPECT_EQ(read("f.mp4").size(), 13u) << "a film that is not finished stands under its name";
  }
  ASSERT_EQ(run({"render", arm_scene, "--frames", "0-9", "--size", "96x54", "-o", "f.mp4"}).exit_code, 0);
  EXPECT_EQ(names(), std::set<std::string>{"f.mp4"});
}

TEST_F(Sequence, TheNumberOfThreadsChangesNothing) {
  std::map<std::string, std::set<std::string>> hashes;
  for (const char* threads : {"1", "2"}) {
    const ProgramOptions options{.environment = {{"LP_NUM_THREADS", threads}}};
    const auto pictures =
        json({"render", arm_scene, "--frames", "0-40:4", "--size", "160x90", "-o", "x_##.png"}, options);
    for (const auto& frame : pictures["frames"]) hashes[frame["file"]].insert(frame["sha256"].get<std::string>());
    for (const char* film : {"x.mp4", "x.webm", "x.gif"})
      hashes[film].insert(
          json({"render", arm_scene, "--frames", "0-40:4", "--size", "160x90", "-o", film}, options)["sha256"]
              .get<std::string>());
  }
  EXPECT_EQ(hashes.size(), 11u + 3u);
  for (const auto& [file, found] : hashes) EXPECT_EQ(found.size(), 1u) << file;
}

TEST_F(Sequence, FramesAreReportedInTheOrderThatWasAskedFor) {
  // With --resume some of them come from the disk, sooner than those that are drawn.
  ASSERT_EQ(run({"render", arm_scene, "--frames", "7,3,9", "--size", "64x36", "-o", "x_##.png"}).exit_code, 0);
  const auto report =
      json({"render", arm_scene, "--frames", "9,8,7,0-6", "--size", "64x36", "-o", "x_##.png", "--resume"});
  std::vector<int> order;
  for (const auto& frame : report["frames"]) order.push_back(frame["frame"]);
  EXPECT_EQ(order, (std::vector<int>{9, 8, 7, 0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(frames(report, true), (std::set<int>{3, 7, 9}));
}

TEST_F(Sequence, ShardsAreContiguousAndMakeTheWhole) {
  const auto whole = render({});
  std::map<std::string, Bytes> files;
  for (const std::string& name : names()) files[name] = read(name);
  std::vector<std::pair<int, std::string>> parts;
  for (const auto& entry : fs::directory_iterator(path(""))) fs::remove(entry);
  for (const char* shard : {"0/3", "1/3", "2/3"}) {
    const auto report = render({"--shard", shard});
    EXPECT_GE(report["frames"].size(), 3u) << shard;
    EXPECT_LE(report["frames"].size(), 4u) << shard;
    for (const auto& frame : report["frames"]) parts.emplace_back(frame["frame"], frame["sha256"]);
  }
  ASSERT_EQ(parts.size(), 10u);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(parts[i].first, static_cast<int>(i));
    EXPECT_EQ(parts[i].second, whole["frames"][i]["sha256"]);
  }
  EXPECT_EQ(names().size(), files.size());
  for (const auto& [name, bytes] : files) EXPECT_EQ(read(name), bytes) << name;
}

TEST_F(Sequence, ShardThatCannotBeIsWrongUsage) {
  for (const char* shard : {"3/3", "-1/3", "0/0", "1", "a/b", "0/3/4"}) {
    const ProgramResult result = run({"render", "absent.json", "--shard", shard, "-o", "x_##.png"});
    EXPECT_EQ(result.exit_code, 2) << result;
    EXPECT_NE(result.err.find("--shard"), std::string::npos) << result;
  }
}

}  // namespace
}  // namespace sinew::test
