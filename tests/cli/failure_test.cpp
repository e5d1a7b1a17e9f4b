/// Failed checks, bad input and missing devices: the exit code, and a message that says what is wrong, where, and what
/// would be right.

#include "tests/support/program.h"

namespace sinew::test {
namespace {

class Failure : public ProgramTest {
 protected:
  /// The run must end with `code`, say every one of `words`, and write nothing on stdout.
  void expect_failure(int code, const Arguments& arguments, const std::vector<std::string>& words,
                      const ProgramOptions& options = {}) const {
    const ProgramResult result = run(arguments, options);
    EXPECT_EQ(result.exit_code, code) << result;
    EXPECT_EQ(result.out, "") << result;
    for (const std::string& word : words)
      EXPECT_NE(result.err.find(word), std::string::npos) << "the message does not say " << word << result;
  }
};

const ProgramOptions no_driver{
    .environment = {{"VK_DRIVER_FILES", "/nonexistent"}, {"VK_ICD_FILENAMES", "/nonexistent"}}};

TEST_F(Failure, UnknownJointIsToldTheNearest) {
  expect_failure(3, {"render", arm_scene, "--pose", "leftLowerArn=0,-90,0", "-o", "x.png"},
                 {"leftLowerArn", "\"leftLowerArm\""});
  expect_failure(3, {"export", arm(), "--pose", "leftHend=0,0,0", "-o", "x.obj"},
                 {"arm.glb", "leftHend", "\"leftHand\""});
  expect_failure(3, {"parity", arm(), "--pose", "leftHend=0,0,0"}, {"arm.glb", "leftHend", "\"leftHand\""});
  expect_failure(3, {"info", arm(), "--pose", "leftHend=0,0,0"}, {"arm.glb", "leftHend", "\"leftHand\""});
  EXPECT_EQ(names(), std::set<std::string>{"arm.glb"});
}

TEST_F(Failure, UnknownClipIsToldTheNearest) {
  const ProgramResult baked = run({"export", arm_scene, "--frames", "0-3", "-o", "baked.glb"});
  ASSERT_EQ(baked.exit_code, 0) << baked;
  for (const char* command : {"render", "export"})
    expect_failure(
        3, {command, "baked.glb", "--clip", "bakde", "-o", command == std::string("render") ? "x.png" : "x.obj"},
        {"baked.glb", "bakde", "\"baked\""});
  expect_failure(3, {"parity", "baked.glb", "--clip", "7"}, {"baked.glb", "7", "it has 1"});
  expect_failure(3, {"render", arm(), "--clip", "Walk", "-o", "x.png"}, {"arm.glb", "Walk", "none at all"});
}

TEST_F(Failure, WhatIsNoModelIsRefused) {
  write("words.json", "once upon a time");
  write("empty.glb", "");
  write("list.json", "[1, 2, 3]");
  for (const char* file : {"words.json", "empty.glb", "list.json", ".", "/dev/null"}) {
    expect_failure(3, {"info", file}, {std::string("error: ") + file});
    expect_failure(3, {"render", file, "-o", "x.png"}, {std::string("error: ") + file});
  }
}

/// Broken scenes, and what the message must name: the JSON pointer of the place, and what would be right.
struct BrokenScene {
  const char* text;
  std::vector<std::string> named;
};

const std::vector<BrokenScene> broken_scenes{
    {R"({"sinew": 1, "characters": [{"model": "arm.glb", "muscles": [{"preset": "bicep", "side": "left"}]}]})",
     {"/characters/0/muscles/0/preset", "\"biceps\""}},
    {R"({"sinew": 1, "characters": [{"model": "arm.glb", "kees": {}}]})", {"/characters/0/kees", "\"keys\""}},
    {R"({"sinew": 1, "characters": [{"model": "arm.glb", "keys": {"leftLowerArm": [[0, [0, 0]]]}}]})",
     {"/characters/0/keys/leftLowerArm/0/1", "three numbers"}},
    {R"({"sinew": 1, "characters": [{"model": "arm.glb", "keys": {"leftLowerArn": [[0, [0, 0, 0]]]}}]})",
     {"/characters/0/keys/leftLowerArn", "\"leftLowerArm\""}},
    {R"({"sinew": 1, "characters": [{"model": "arm.glb", "count": 2}]})", {"/characters/0/count"}},
    {R"({"sinew": 1, "characters": [{"model": "arm.glb", "expressions": [[0, "smle", 1]]}]})",
     {"/characters/0/expressions/0/1", "\"smile\""}},
    {R"({"sinew": 1, "characters": [{"model": "arm.glb", "clip": "Walk"}]})", {"/characters/0/clip", "Walk"}},
    {R"({"sinew": 1, "characters": [{"model": "arm.glb"}, {"model": "absent.glb"}]})",
     {"/characters/1/model", "absent.glb"}},
    {R"({"sinew": 1, "characters": [{"model": "arm.glb", "muscles": [{"preset": "biceps", "side": "left"},
        {"name": "m", "bone": "leftUpperArm", "child": "leftLowerArn", "driver": "leftLowerArm", "facing": [0, 0, 1],
         "from": 0.3, "to": 1, "spread": 60, "peak": 0.01, "sigma": [0.06, 0.03], "rest_angle": 180,
         "reference_angle": 35}]}]})",
     {"/characters/0/muscles/1", "\"leftLowerArm\""}},
    {R"({"sinew": 1, "characters": [{"model": "arm.glb"}], "camera": {"view": "fornt"}})",
     {"/camera/view", "\"front\""}},
    {R"({"sinew": 1, "characters": [{"model": "arm.glb"}], "look": {"shading": "cley"}})",
     {"/look/shading", "\"clay\""}},
    {R"({"sinew": 1, "characters": [{"model": "arm.glb"}], "frames": [5, 1]})", {"/frames", "first <= last"}},
    {R"({"sinew": 1, "characters": [{"model": "arm.glb"}], "fps": "24"})", {"/fps", "\"24\""}},
    {R"({"sinew": 2, "characters": [{"model": "arm.glb"}]})", {"/sinew", "expected 1"}},
    {R"({"sinew": 1, "characters": []})", {"/characters"}},
    {R"({"sinew": 1, "characters": [{"model": "arm.glb"}])", {"line 1"}},
};

TEST_F(Failure, BrokenSceneIsToldItsJsonPointer) {
  arm();
  for (const BrokenScene& broken : broken_scenes) {
    write("broken.json", broken.text);
    std::vector<std::string> named = broken.named;
    named.insert(named.begin(), "broken.json");
    expect_failure(3, {"render", "broken.json", "-o", "x.png"}, named);
    expect_failure(3, {"info", "broken.json", "--json"}, named);
  }
  EXPECT_EQ(names(), (std::set<std::string>{"arm.glb", "broken.json"}));
}

TEST_F(Failure, WithoutADriverTheExitCodeIsFour) {
  expect_failure(4, {"render", arm_scene, "-o", "x.png"}, {"Vulkan"}, no_driver);
  expect_failure(4, {"parity"}, {"Vulkan"}, no_driver);
  expect_failure(4, {"export", arm_scene, "-o", "x.obj"}, {"Vulkan"}, no_driver);
  expect_failure(4, {"bench"}, {"Vulkan"}, no_driver);
  expect_failure(4, {"info", "--devices"}, {"Vulkan"}, no_driver);
  EXPECT_TRUE(names().empty());
}

TEST_F(Failure, WhatNeedsNoDeviceWorksWithoutADriver) {
  for (const Arguments& arguments :
       {Arguments{"export", arm_scene, "--by", "cpu", "-o", "x.obj"},
        Arguments{"export", arm_scene, "--rig", "-o", "x.glb"}, Arguments{"info", "x.glb"}}) {
    const ProgramResult result = run(arguments, no_driver);
    EXPECT_EQ(result.exit_code, 0) << result;
  }
}

TEST_F(Failure, UnknownDeviceIsToldTheKnownOnes) {
  const std::string known = json({"info", "--devices"})["devices"][0]["name"];
  expect_failure(4, {"render", arm_scene, "-o", "x.png", "--device", "Voodoo"}, {"Voodoo", known});
  expect_failure(4, {"render", arm_scene, "-o", "x.png", "--device", "99"}, {"99", known});
  expect_failure(4, {"parity"}, {"Voodoo", known}, {.environment = {{"SINEW_DEVICE", "Voodoo"}}});
}

TEST_F(Failure, DeviceIsTakenByIndexByNameAndFromTheEnvironment) {
  const std::string known = json({"info", "--devices"})["devices"][0]["name"];
  for (const std::string& device : {std::string("0"), known, known.substr(0, 4)}) {
    EXPECT_EQ(json({"parity", arm_scene, "--frame", "0", "--device", device})["device"]["name"], known);
    EXPECT_EQ(
        json({"parity", arm_scene, "--frame", "0"}, {.environment = {{"SINEW_DEVICE", device}}})["device"]["name"],
        known);
  }
  // The option wins over the environment.
  EXPECT_EQ(run({"parity", arm_scene, "--frame", "0", "--device", "0"}, {.environment = {{"SINEW_DEVICE", "Voodoo"}}})
                .exit_code,
            0);
}

TEST_F(Failure, TheLogNamesTheDeviceAndSaysIfItIsACpu) {
  const auto device = json({"info", "--devices"})["devices"][0];
  const ProgramResult result = run({"render", arm_scene, "-o", "x.png", "--size", "64x64"});
  EXPECT_NE(result.err.find(device["name"].get<std::string>()), std::string::npos) << result;
  EXPECT_EQ(result.err.find("CPU") != std::string::npos, device["type"] == "cpu") << result;
  EXPECT_EQ(run({"render", arm_scene, "-o", "x.png", "--size", "64x64", "--quiet"}).err, "");
}

TEST_F(Failure, ParityThatDoesNotHoldFails) {
  const ProgramResult result = run({"parity", arm_scene, "--tolerance", "0", "--json"});
  EXPECT_EQ(result.exit_code, 1) << result;
  EXPECT_EQ(json_of(result)["pass"], false);
  EXPECT_NE(result.err.find("parity failed"), std::string::npos) << result;
}

TEST_F(Failure, PicturesThatDifferFail) {
  ASSERT_EQ(run({"render", arm_scene, "--frames", "0,30", "--size", "64x64", "-o", "x_##.png"}).exit_code, 0);
  const ProgramResult result = run({"compare", "x_00.png", "x_30.png", "--diff", "difference.png", "--json"});
  EXPECT_EQ(result.exit_code, 1) << result;
  const auto report = json_of(result);
  EXPECT_EQ(report["pass"], false);
  EXPECT_GT(report["pixels_over"], 0);
  EXPECT_EQ(picture("difference.png").width, 64);
  ASSERT_EQ(run({"render", arm_scene, "--size", "64x65", "-o", "other.png"}).exit_code, 0);
  expect_failure(3, {"compare", "x_00.png", "other.png"}, {"64x64", "64x65"});
  write("text.png", "not a picture");
  expect_failure(3, {"compare", "x_00.png", "text.png"}, {"text.png"});
}

}  // namespace
}  // namespace sinew::test
