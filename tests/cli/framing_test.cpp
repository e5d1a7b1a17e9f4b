/// The subject is in the picture: whole, and large enough to see.

#include "tests/support/assets.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

class Framing : public ProgramTest {
 protected:
  /// An arm that swings from straight to bent, without a camera of its own: the program frames it.
  std::string swing() const {
    arm();
    write("swing.json", R"({"sinew": 1, "frames": [0, 47], "characters": [{"model": "arm.glb",
        "keys": {"leftLowerArm": [[0, [0, 0, 0]], [47, [0, -130, 0]]]}}]})");
    return "swing.json";
  }
};

/// Which pixels the subject covers, over one or more pictures on a transparent background.
struct Coverage {
  int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1;  ///< of the covered pixels
  std::size_t least = SIZE_MAX;                                ///< pixels covered in any one picture
  int width = 0, height = 0;

  void add(const DecodedPng& png) {
    width = png.width;
    height = png.height;
    std::size_t count = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (png.rgba[4 * (std::size_t(y) * std::size_t(width) + std::size_t(x)) + 3] != 0) {
          ++count;
          left = std::min(left, x), right = std::max(right, x);
          top = std::min(top, y), bottom = std::max(bottom, y);
        }
    least = std::min(least, count);
  }

  bool touches_border() const { return left == 0 || top == 0 || right == width - 1 || bottom == height - 1; }
  /// The larger of how much of the width and of the height is taken.
  double extent() const { return std::max(double(right - left + 1) / width, double(bottom - top + 1) / height); }
};

std::ostream& operator<<(std::ostream& stream, const Coverage& c) {
  return stream << "x " << c.left << "-" << c.right << " of " << c.width << ", y " << c.top << "-" << c.bottom << " of "
                << c.height << ", at least " << c.least << " pixels a picture";
}

const char* const views[] = {"front", "back", "left", "right", "top", "three-quarter"};

TEST_F(Framing, EveryViewShowsTheWholeSwing) {
  swing();
  for (const char* view : views) {
    const ProgramResult result = run({"render", "swing.json", "--view", view, "--frames", "0-47", "--size", "192x108",
                                      "--background", "transparent", "-o", std::string(view) + "_##.png"});
    ASSERT_EQ(result.exit_code, 0) << result;
    Coverage coverage;
    for (int frame = 0; frame < 48; ++frame) coverage.add(picture(fmt::format("{}_{:02}.png", view, frame)));
    EXPECT_FALSE(coverage.touches_border()) << view << ": " << coverage;
    EXPECT_GE(coverage.extent(), 0.5) << view << ": " << coverage;
    // An arm seen along its length is small, but it is seen.
    EXPECT_GE(double(coverage.least) / (192 * 108), 0.01) << view << ": " << coverage;
  }
}

TEST_F(Framing, TheEmbeddedSceneFillsItsPicture) {
  ASSERT_EQ(run({"render", "--size", "192x108", "--background", "transparent", "-o", "x_##.png"}).exit_code, 0);
  Coverage coverage;
  for (int frame = 0; frame < 48; ++frame) coverage.add(picture(fmt::format("x_{:02}.png", frame)));
  EXPECT_FALSE(coverage.touches_border()) << coverage;
  EXPECT_GE(coverage.extent(), 0.7) << coverage;
  EXPECT_GE(double(coverage.least) / (192 * 108), 0.05) << coverage;
}

TEST_F(Framing, EveryShapeOfPictureShowsAll) {
  swing();
  for (const char* size : {"300x60", "60x300", "100x100"}) {
    Coverage coverage;
    for (const char* frame : {"0", "47"}) {
      const ProgramResult result =
          run({"render", "swing.json", "--frame", frame, "--size", size, "--background", "transparent", "-o", "x.png"});
      ASSERT_EQ(result.exit_code, 0) << result;
      coverage.add(picture("x.png"));
    }
    EXPECT_FALSE(coverage.touches_border()) << size << ": " << coverage;
    // The frames between these two reach further.
    EXPECT_GE(coverage.extent(), 0.4) << size << ": " << coverage;
  }
}

TEST_F(Framing, TheCameraStandsStillWhicheverFramesAreAskedFor) {
  // What is drawn with only one frame selected is what that frame shows in the whole sequence.
  swing();
  ASSERT_EQ(run({"render", "swing.json", "--frames", "0-47:47", "--size", "96x54", "-o", "x_##.png"}).exit_code, 0);
  ASSERT_EQ(run({"render", "swing.json", "--frame", "47", "--size", "96x54", "-o", "alone.png"}).exit_code, 0);
  EXPECT_EQ(read("x_47.png"), read("alone.png"));
}

TEST_F(Framing, OrbitTurnsAllTheWay) {
  ASSERT_EQ(run({"render", arm_scene, "--view", "front", "--orbit", "0", "--size", "96x54", "-o", "a.png"}).exit_code,
            0);
  ASSERT_EQ(run({"render", arm_scene, "--view", "front", "--orbit", "180", "--size", "96x54", "-o", "b.png"}).exit_code,
            0);
  ASSERT_EQ(run({"render", arm_scene, "--view", "back", "--orbit", "0", "--size", "96x54", "-o", "c.png"}).exit_code,
            0);
  // Half a turn in floating point may move the silhouette's pixels.
  EXPECT_EQ(run({"compare", "b.png", "c.png", "--tolerance", "3", "--pixels", "0.01"}).exit_code, 0);
  EXPECT_EQ(run({"compare", "a.png", "c.png", "--tolerance", "3", "--pixels", "0.01"}).exit_code, 1);
}

TEST_F(Framing, EveryCharacterIsInItsPicture) {
  SINEW_ASSETS_OR_SKIP(assets);
  std::vector<Arguments> runs;
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(assets / "characters")) {
    const std::string ending = entry.path().extension().string();
    // mesh2motion's rig-human is a skeleton alone.
    if ((ending == ".glb" || ending == ".gltf" || ending == ".vrm") && entry.path().stem() != "rig-human")
      runs.push_back({"render", entry.path().string(), "--view", "three-quarter", "--frames", "0,7,23", "--size",
                      "192x108", "--background", "transparent", "-o", fmt::format("{}_##.png", count++)});
  }
  ASSERT_GT(runs.size(), 15u);
  const auto results = run_all(runs);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(results[i].exit_code, 0) << results[i];
    if (results[i].exit_code != 0) continue;
    Coverage coverage;
    for (const char* frame : {"00", "07", "23"}) coverage.add(picture(fmt::format("{}_{}.png", i, frame)));
    EXPECT_FALSE(coverage.touches_border()) << runs[i][1] << ": " << coverage;
    EXPECT_GE(double(coverage.least) / (192 * 108), 0.01) << runs[i][1] << ": " << coverage;
  }
}

}  // namespace
}  // namespace sinew::test
