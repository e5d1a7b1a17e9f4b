/// Overlays, panels, insets, sheets, turntables and films, as a user asks for them.

#include <csignal>
#include <thread>

#include "tests/support/program.h"

namespace sinew::test {
namespace {

class Figure : public ProgramTest {
 protected:
  DecodedPng render(Arguments words) const {
    words.insert(words.begin(), {"render", arm_scene});
    words.insert(words.end(), {"-o", path("figure.png"), "--quiet"});
    const ProgramResult result = run(words);
    EXPECT_EQ(result.exit_code, 0) << result;
    return picture("figure.png");
  }
};

std::size_t differing_pixels(const DecodedPng& a, const DecodedPng& b) {
  EXPECT_EQ(a.rgba.size(), b.rgba.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < std::min(a.rgba.size(), b.rgba.size()); i += 4)
    count += std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i]) ? 0 : 1;
  return count;
}

const Arguments small{"--size", "480x270"};

Arguments with(Arguments words) {
  words.insert(words.begin(), small.begin(), small.end());
  return words;
}

TEST_F(Figure, EveryOverlayLeavesInk) {
  const DecodedPng plain = render(with({"--frame", "40"}));
  for (const char* overlay : {"skeleton", "muscles", "box", "axes"})
    // A tripod of axes is the smallest of them: three strokes and letters.
    EXPECT_GT(differing_pixels(plain, render(with({"--frame", "40", "--overlay", overlay}))), 100u) << overlay;
}

TEST_F(Figure, TheWholeHasTheSizeThatWasAskedFor) {
  for (const Arguments& words : std::vector<Arguments>{{"--compare", "bulge"},
                                                       {"--compare", "deformer", "--zoom", "leftLowerArm"},
                                                       {"--sheet", "3x2"},
                                                       {"--sheet", "5x3", "--compare", "bulge"},
                                                       {"--overlay", "skeleton,muscles"}}) {
    Arguments sized{"--size", "401x233"};
    sized.insert(sized.end(), words.begin(), words.end());
    const DecodedPng png = render(sized);
    EXPECT_EQ(png.width, 401) << words[0];
    EXPECT_EQ(png.height, 233) << words[0];
  }
}

/// Each panel is the plain picture of its size, pixel by pixel, but for the label in its lower left corner.
TEST_F(Figure, PanelsAreThePicturesThatTheyName) {
  const auto expect_panels = [&](const Arguments& together, const std::array<Arguments, 2>& apart) {
    Arguments words{"--size", "616x316", "--frame", "47"};
    words.insert(words.end(), together.begin(), together.end());
    const DecodedPng both = render(words);
    for (const int panel : {0, 1}) {
      words = {"--size", "296x300", "--frame", "47"};
      words.insert(words.end(), apart[panel].begin(), apart[panel].end());
      const DecodedPng alone = render(words);
      std::size_t same = 0, compared = 0;
      for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 296; ++x, ++compared)
          same += std::equal(&alone.rgba[(y * 296 + x) * 4], &alone.rgba[(y * 296 + x) * 4] + 4,
                             &both.rgba[((y + 8) * 616 + x + 8 + 304 * panel) * 4]);
      EXPECT_EQ(same, compared) << together.back() << ", panel " << panel;
    }
  };
  expect_panels({"--compare", "bulge"}, {{{"--bulge", "on"}, {"--bulge", "off"}}});
  expect_panels({"--view", "front", "--compare", "left"}, {{{"--view", "front"}, {"--view", "left"}}});
}

TEST_F(Figure, CompareWithAnotherScene) {
  const std::string other = arm();
  const DecodedPng png = render({"--size", "480x270", "--compare", other});
  EXPECT_EQ(png.width, 480);
  EXPECT_EQ(run({"render", arm_scene, "--compare", "absent.glb", "-o", "x.png"}).exit_code, 3);
}

TEST_F(Figure, AnInsetShowsWhatThePictureDoesNot) {
  const DecodedPng plain = render(with({"--frame", "30"}));
  const DecodedPng zoomed = render(with({"--frame", "30", "--zoom", "leftLowerArm"}));
  const std::size_t inset = std::size_t(0.36 * 270) * std::size_t(0.36 * 270);
  EXPECT_GT(differing_pixels(plain, zoomed), inset / 8);
  EXPECT_LT(differing_pixels(plain, zoomed), 2 * inset);
  const ProgramResult unknown = run({"render", arm_scene, "--zoom", "leftLowrArm", "-o", "x.png"});
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_NE(unknown.err.find("leftLowerArm"), std::string::npos) << unknown;
}

TEST_F(Figure, ATurntableGoesRound) {
  const Arguments words{"render", arm_scene,     "--size", "160x90", "--frame",
                        "30",     "--turntable", "4",      "-o",     path("t_##.png")};
  const nlohmann::json report = json(words);
  ASSERT_EQ(report["frames"].size(), 4u);
  const DecodedPng quarter = picture("t_01.png");
  EXPECT_EQ(picture("t_00.png").rgba, render({"--size", "160x90", "--frame", "30"}).rgba);
  // The scene's own orbit is -20 degrees.
  EXPECT_EQ(quarter.rgba, render({"--size", "160x90", "--frame", "30", "--orbit", "70"}).rgba);
}

TEST_F(Figure, WordsThatAreNoneAreRefusedBeforeAFileIsOpened) {
  for (const Arguments& words : std::vector<Arguments>{{"--overlay", "skeletn"},
                                                       {"--sheet", "4"},
                                                       {"--sheet", "0x3"},
                                                       {"--turntable", "-1"},
                                                       {"--turntable", "0"},
                                                       {"--turntable", "3"},
                                                       {"--shard", "3/3"},
                                                       {"--sheet", "2x2", "--turntable", "3"}}) {
    Arguments all{"render", "absent.json", "-o", "x.png"};
    all.insert(all.end(), words.begin(), words.end());
    EXPECT_EQ(run(all).exit_code, 2) << words[0] << ' ' << words[1];
  }
}

TEST_F(Figure, FilmsAreReportedWithTheirFramesHashes) {
  for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
    const Arguments words{"render", arm_scene, "--size", "160x90", "--frames", "0-5", "-o", path(name)};
    const nlohmann::json first = json(words), second = json(words);
    EXPECT_EQ(first["sha256"], sha256(read(name))) << name;
    EXPECT_EQ(first["sha256"], second["sha256"]) << name;
    EXPECT_EQ(first["frames"].size(), 6u);
    EXPECT_NE(first["frames"][0]["sha256"], first["frames"][5]["sha256"]);
  }
  EXPECT_EQ(names(), (std::set<std::string>{"a.mp4", "a.webm", "a.gif"}));
  EXPECT_EQ(run({"render", arm_scene, "--shard", "0/2", "-o", "b.mp4"}).exit_code, 2);
  EXPECT_EQ(run({"render", arm_scene, "-o", "missing/b.mp4"}).exit_code, 7);
}

TEST_F(Figure, AnInterruptedFilmLeavesNothing) {
  RunningProgram program({"render", arm_scene, "--size", "640x360", "--frames", "0-100000", "-o", path("long.mp4")});
  std::this_thread::sleep_for(std::chrono::seconds(1));
  program.send(SIGINT);
  const ProgramResult result = program.finish();
  EXPECT_EQ(result.exit_code, 130) << result;
  EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace sinew::test
