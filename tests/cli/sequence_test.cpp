/// Sequences that are taken up again or shared between machines.

#include <csignal>
#include <thread>

#include "tests/support/program.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

class Sequence : public ProgramTest {
 protected:
  nlohmann::json render(const Arguments& more) const {
    Arguments all{"render", "--frames", "0-9", "--size", "64x36", "-o", "x_##.png"};
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
  const Arguments words{"render", "--frames", "0-199", "--size", "320x180", "-o", "y_###.png"};
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

TEST_F(Sequence, ShardsAreContiguousAndMakeTheWhole) {
  const auto whole = render({});
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
