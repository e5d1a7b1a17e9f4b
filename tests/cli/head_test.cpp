/// `sinew head` as a user meets it.

#include "tests/support/glb.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

class HeadCommand : public ProgramTest {};

TEST_F(HeadCommand, WritesAFileThatTheOtherCommandsTake) {
  const nlohmann::json made = json({"head", "--level", "1", "-o", "head.glb"});
  EXPECT_EQ(made.at("file"), "head.glb");
  EXPECT_NEAR(made.at("height").get<double>(), 0.23, 1e-9);
  const nlohmann::json info = json({"info", "head.glb"});
  EXPECT_EQ(info.at("vertices"), made.at("vertices"));
  EXPECT_EQ(info.at("triangles"), made.at("triangles"));
  EXPECT_EQ(info.at("morph_targets"), made.at("morph_targets"));
  // A head alone is no humanoid; nothing else is wrong with it.
  for (const nlohmann::json& problem : info.at("problems"))
    EXPECT_EQ(problem.get<std::string>().find("not a whole humanoid"), 0u) << problem;
  EXPECT_EQ(json({"parity", "head.glb"}).at("pass"), true);
}

TEST_F(HeadCommand, ListsLandmarksInTheFilesUnits) {
  json({"head", "--level", "1", "--age", "infant", "-o", "head.glb"});
  const nlohmann::json extras = glb_json(read("head.glb")).at("meshes").at(0).at("extras");
  const nlohmann::json& marks = extras.at("landmarks");
  for (const char* name :
       {"crown", "hairLine", "brow", "eyeLine", "noseBase", "lipContact", "chin", "earTop", "earBottom"})
    EXPECT_TRUE(marks.contains(name)) << name;
  const auto y = [&](const char* name) { return marks.at(name).at("position").at(1).get<double>(); };
  EXPECT_NEAR(y("crown") - y("chin"), 0.17, 1e-6);
  EXPECT_NEAR(extras.at("drawingUnit").get<double>(), 0.17 / 3.5, 1e-9);
}

TEST_F(HeadCommand, SavedMeasuresMakeTheSameHead) {
  json({"head", "--level", "0", "--age", "0.4", "--skull", "round=0.5", "--measure", "nose_width=0.3",
        "--save-measures", "m.json", "-o", "one.glb"});
  json({"head", "--level", "0", "--measures", "m.json", "-o", "other.glb"});
  EXPECT_EQ(read("one.glb"), read("other.glb"));
}

TEST_F(HeadCommand, ExpressionsAreShownAndHeldMovesReported) {
  const nlohmann::json made =
      json({"head", "--level", "1", "--expression", "laugh=3", "--region", "eyeLeft=90,0", "-o", "laugh.glb"});
  EXPECT_EQ(made.at("morph_targets"), 0);
  bool jaw = false, gaze = false;
  for (const nlohmann::json& held : made.at("held")) {
    jaw = jaw || held.at("region") == "jaw";
    gaze = gaze || held.at("region") == "eyeLeft.yaw";
  }
  EXPECT_TRUE(jaw && gaze) << made.at("held");
}

TEST_F(HeadCommand, SkullsThatPullTheSameWayMakeAHead) {
  EXPECT_EQ(run({"head", "--level", "0", "--age", "infant", "--skull", "wide=1,round=1", "-o", "x.glb"}).exit_code, 0);
  const ProgramResult typed = run({"head", "--level", "0", "--measure", "width_mouth=1.5", "-o", "x.glb"});
  EXPECT_EQ(typed.exit_code, 3) << typed;
}

TEST_F(HeadCommand, ABodyWithoutAFaceIsWarnedOf) {
  EXPECT_EQ(run({"export", "builtin:woman", "--rig", "-o", "woman.glb"}).exit_code, 0);
  const ProgramResult result = run({"head", "--on", "woman.glb", "-o", "faced.glb", "--json"});
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.err.find("warning: woman.glb: neither nose, lips nor eyes"), std::string::npos) << result;
  EXPECT_EQ(nlohmann::json::parse(result.out).at("problems").size(), 1u);
  EXPECT_TRUE(nlohmann::json::parse(result.out).at("landmarks").contains("noseTip"));
  write("scene.json", R"({"sinew": 1, "characters": [{"model": "woman.glb", "landmarks": "auto"}]})");
  const nlohmann::json info = json({"info", "scene.json"});
  EXPECT_EQ(info.at("face").at("landmarks").at("noseTip").size(), 3u);
  const std::string problems = info.at("problems").dump();
  EXPECT_NE(problems.find("neither nose, lips nor eyes"), std::string::npos) << problems;
}

TEST_F(HeadCommand, OverlaysOfAFaceThatIsNotThereAreNamed) {
  json({"head", "--level", "0", "-o", "head.glb"});
  const auto warned = [&](const std::string& model) {
    const ProgramResult result =
        run({"render", model, "--overlay", "guides,regions", "--size", "64x64", "-o", "picture.png"});
    EXPECT_EQ(result.exit_code, 0) << result;
    const auto at = result.err.find("the overlay of guides, regions shows nothing of it: ");
    return at == std::string::npos ? std::string() : result.err.substr(at);
  };
  EXPECT_NE(warned("builtin:arm").find("it has no face"), std::string::npos);
  EXPECT_NE(warned("head.glb").find("morph targets without regions"), std::string::npos);
  EXPECT_EQ(warned("builtin:head"), "");
}

TEST_F(HeadCommand, AHalfIsMirrored) {
  write("half.obj", "v 0 0 0\nv 0 1 0\nv 1 1 0\nv 1 0 0\nv 0.00001 2 0\nf 1 4 3 2\nf 2 3 5\n");
  const nlohmann::json made = json({"head", "--half", "half.obj", "-o", "whole.glb"});
  EXPECT_EQ(made.at("vertices"), 7);
  EXPECT_EQ(made.at("triangles"), 6);
  write("both.obj", "v -1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(run({"head", "--half", "both.obj", "-o", "x.glb"}).exit_code, 3);
  write("away.obj", "v 1 0 0\nv 2 0 0\nv 1 1 0\nf 1 2 3\n");
  EXPECT_EQ(run({"head", "--half", "away.obj", "-o", "x.glb"}).exit_code, 3);
  write("fan.obj", "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 1 0 1\nf 1 2 3\nf 1 2 4\n");
  EXPECT_EQ(run({"head", "--half", "fan.obj", "-o", "x.glb"}).exit_code, 3);
  EXPECT_EQ(run({"head", "--half", "half.obj", "--age", "child", "-o", "x.glb"}).exit_code, 2);
  EXPECT_FALSE(names().contains("x.glb"));
}

TEST_F(HeadCommand, OddWordsAreNamedAndNothingIsWritten) {
  struct Odd {
    Arguments words;
    int exit_code;
    std::string named;
  };
  write("broken.json", "{\"sinew_head\": 1, \"measures\": {\"nose_width\": 9}}");
  const std::vector<Odd> odd{{{"--age", "adlut"}, 2, "adult"},
                             {{"--age", "2"}, 2, "--age"},
                             {{"--skull", "rond"}, 2, "round"},
                             {{"--level", "9"}, 2, "--level"},
                             {{"--measure", "nose_width"}, 2, "NAME=VALUE"},
                             {{"--measure", "nose_widht=0.3"}, 3, "nose_width"},
                             {{"--measure", "nose_width=9"}, 3, "0.15"},
                             {{"--measure", "eye_height=2.2"}, 3, "cross"},
                             {{"--measures", "absent.json"}, 3, "absent.json"},
                             {{"--measures", "broken.json"}, 3, "/measures/nose_width"},
                             {{"--expression", "smlie"}, 3, "smile"},
                             {{"--expression", "smile=x"}, 2, "smile=x"},
                             {{"--region", "jawl=1"}, 3, "jaw"},
                             {{"--half", "absent.glb"}, 3, "absent.glb"}};
  for (const Odd& o : odd) {
    Arguments arguments{"head", "-o", "head.glb"};
    arguments.insert(arguments.end(), o.words.begin(), o.words.end());
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, o.exit_code) << result;
    EXPECT_NE(result.err.find(o.named), std::string::npos) << result;
  }
  EXPECT_EQ(run({"head", "-o", "head.obj"}).exit_code, 2);
  EXPECT_EQ(run({"head", "-o", "missing/head.glb"}).exit_code, 7);
  EXPECT_FALSE(names().contains("head.glb"));
}

}  // namespace
}  // namespace sinew::test
