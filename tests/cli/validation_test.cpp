/// The Vulkan validation layer has nothing to say about any command.

#include "tests/support/program.h"

namespace sinew::test {
namespace {

class Validation : public ProgramTest {
 protected:
  void SetUp() override {
    const ProgramResult result = run({"parity", arm_scene, "--frame", "0", "--validate"});
    if (result.exit_code == 4 && result.err.find("VK_LAYER_KHRONOS_validation") != std::string::npos)
      GTEST_SKIP() << "SKIPPED: the Vulkan validation layer is not installed (Debian: vulkan-validationlayers)";
  }

  void expect_silence(Arguments arguments) const {
    arguments.emplace_back("--validate");
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result;
    EXPECT_EQ(result.err.find("VUID"), std::string::npos) << result;
  }
};

TEST_F(Validation, Render) {
  expect_silence({"render", arm_scene, "--frames", "0,47", "--size", "160x90", "-o", "x_##.png"});
  expect_silence(
      {"render", arm_scene, "--size", "161x91", "--samples", "4", "--background", "transparent", "-o", "x.png"});
  for (const char* shading : {"lit", "flat", "clay", "normals", "bulge", "depth"})
    expect_silence({"render", arm_scene, "--size", "1x1", "--shading", shading, "-o", "x.png"});
}

TEST_F(Validation, Parity) {
  for (const char* deformer : {"rigid", "ssd"})
    for (const char* bulge : {"on", "off", "paper"})
      expect_silence({"parity", arm_scene, "--frames", "0,47", "--deformer", deformer, "--bulge", bulge});
}

TEST_F(Validation, Export) {
  expect_silence({"export", arm_scene, "--frame", "47", "-o", "x.ply"});
  expect_silence({"export", arm_scene, "--frames", "0-3", "-o", "x.glb"});
}

TEST_F(Validation, Bench) { expect_silence({"bench", arm_scene, "--frames-timed", "2", "--size", "160x90"}); }

}  // namespace
}  // namespace sinew::test
