/// Scenes with faces: what is shown, what is refused and what is reported.

#include "engine/core/math.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

class FaceScene : public ProgramTest {
 protected:
  /// A scene of one character with these members.
  void scene(const std::string& members, const std::string& frames = "[0, 12]") const {
    write("scene.json", fmt::format(R"({{"sinew": 1, "frames": {}, "characters": [{{{}}}]}})", frames, members));
  }
  ProgramResult with_scene(const char* command, Arguments more) const {
    more.insert(more.begin(), {command, path("scene.json")});
    return run(more);
  }
};

const std::string head = R"("model": "builtin:head", "head": {"level": 0}, )";

TEST_F(FaceScene, ParityHoldsForEverythingThatAFaceDoes) {
  scene(head.substr(0, head.size() - 3) + R"(, "age": [[0, "adult"], [12, "child"]]}, )"
                                          R"("expressions": [[0, "laugh", 1], [6, "fear", 1], [12, "doubt", 1],
                           {"expression": "blink", "start": 2, "until": 4}],
           "regions": {"lipSeal": [[0, [0]], [12, [1]]], "eyeLeft": [[0, [-15, 8]], [12, [15, -8]]]})");
  const ProgramResult result = with_scene("parity", {"--json"});
  EXPECT_EQ(result.exit_code, 0) << result;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["frames"], 13);
  EXPECT_LE(json["relative_error"].get<double>(), 1e-5);
  EXPECT_LE(json["max_normal_error_degrees"].get<double>(), 0.1);
}

TEST_F(FaceScene, ExpressionsMoveWhatIsExported) {
  scene(head + R"("expressions": [[0, "neutral", 1], [12, "laugh", 1]])");
  const auto ply = [&](const char* frame, const char* by, const std::string& name) {
    const ProgramResult result = with_scene("export", {"--frame", frame, "--by", by, "-o", path(name)});
    EXPECT_EQ(result.exit_code, 0) << result;
    return read(name);
  };
  EXPECT_NE(ply("0", "cpu", "rest.ply"), ply("12", "cpu", "laugh.ply"));
  EXPECT_EQ(ply("12", "cpu", "laugh.ply"), ply("12", "cpu", "again.ply"));
}

TEST_F(FaceScene, WhatIsHeldAtItsLimitIsReportedOnce) {
  scene(head + R"("expressions": [[0, "shout", 1]], "regions": {"jaw": [[0, [0]], [12, [0.5]]]})");
  const ProgramResult result = with_scene("info", {"--json"});
  ASSERT_EQ(result.exit_code, 0) << result;
  const auto json = nlohmann::json::parse(result.out);
  const auto& held = json["face"]["held"];
  ASSERT_EQ(held.size(), 1u) << held;
  EXPECT_EQ(held[0]["region"], "jaw");
  EXPECT_EQ(held[0]["frame"], 12);
  EXPECT_NEAR(held[0]["held"].get<double>(), 0.55, 1e-9);
  EXPECT_NEAR(held[0]["asked"].get<double>(), 1.02, 1e-9);
  EXPECT_FALSE(json["face"]["regions"].empty());
}

TEST_F(FaceScene, AHeadExportedAsARigDoesTheSameByItsMorphTargets) {
  scene(head + R"("expressions": [[0, "smile", 1]])");
  ASSERT_EQ(with_scene("export", {"--rig", "-o", path("rig.glb")}).exit_code, 0);
  ASSERT_EQ(with_scene("export", {"--by", "cpu", "--frame", "0", "-o", path("regions.obj")}).exit_code, 0);
  scene(R"("model": "rig.glb", "expressions": [[0, "smile", 1]])");
  const ProgramResult result = with_scene("export", {"--by", "cpu", "--frame", "0", "-o", path("targets.obj")});
  ASSERT_EQ(result.exit_code, 0) << result;
  const ProgramResult info = with_scene("info", {"--json"});
  EXPECT_FALSE(nlohmann::json::parse(info.out)["face"]["targets"].empty()) << info;
  const auto vertices = [&](const std::string& name) {
    std::vector<Vec3> out;
    const Bytes bytes = read(name);
    std::istringstream lines(std::string(bytes.begin(), bytes.end()));
    for (std::string line; std::getline(lines, line);) {
      Vec3 p;
      if (std::sscanf(line.c_str(), "v %lf %lf %lf", &p.x, &p.y, &p.z) == 3) out.push_back(p);
    }
    return out;
  };
  const std::vector<Vec3> regions = vertices("regions.obj"), targets = vertices("targets.obj");
  ASSERT_EQ(regions.size(), targets.size());
  ASSERT_FALSE(regions.empty());
  // Eyeballs draw back behind linear lids, by up to a tenth of their radius of 2 cm.
  double worst = 0.0;
  for (std::size_t v = 0; v < regions.size(); ++v) worst = std::max(worst, glm::distance(regions[v], targets[v]));
  EXPECT_LE(worst, 0.002);
}

TEST_F(FaceScene, WhatIsWrongIsSaidWithItsPlace) {
  struct Case {
    std::string members, said;
  };
  for (const auto& [members, said] : std::vector<Case>{
           {R"("model": "builtin:arm", "expressions": [[0, "laugh", 1]])",
            "/characters/0/expressions: the model has no face"},
           {R"("model": "builtin:arm", "regions": {"jaw": [[0, [0.1]]]})",
            "/characters/0/regions: the model has no face"},
           {R"("model": "builtin:arm", "head": {"age": "child"})", "/characters/0/head: is for \"builtin:head\""},
           {head + R"("expressions": [[0, "laugth", 1]])", "\"laugh\""},
           {head + R"("expressions": [{"expression": "blnk", "start": 0, "until": 1}])", "\"blink\""},
           {R"("model": "builtin:head", "head": {"skull": "rund"})", "/characters/0/head/skull: no outline \"rund\""},
           {R"("model": "builtin:head", "head": {"file": "none.json"})", "none.json"},
           {R"("model": "builtin:head", "head": {"measures": {"mouth_width": 9}})", "/characters/0/head/measures: "}}) {
    scene(members);
    const ProgramResult result = with_scene("info", {});
    EXPECT_EQ(result.exit_code, 3) << members << result;
    EXPECT_NE(result.err.find(said), std::string::npos) << members << result;
  }
}

TEST_F(FaceScene, AFrameOfAnAgeFilmDependsOnItsNumberAlone) {
  scene(R"("model": "builtin:head", "head": {"level": 0, "age": [[0, "adult"], [12, "infant"]]})");
  ASSERT_EQ(with_scene("render", {"--size", "64x64", "-o", path("all_####.png")}).exit_code, 0);
  ASSERT_EQ(with_scene("render", {"--size", "64x64", "--frame", "7", "-o", path("one.png")}).exit_code, 0);
  EXPECT_EQ(read("all_0007.png"), read("one.png"));
  EXPECT_NE(read("all_0000.png"), read("all_0012.png"));
}

TEST_F(FaceScene, BenchTellsWhatAFaceCosts) {
  const ProgramResult result =
      run({"bench", "builtin:head", "--vertices", "3000", "--size", "64x64", "--frames-timed", "5", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_TRUE(nlohmann::json::parse(result.out)["face_ms"].is_number()) << result;
}

}  // namespace
}  // namespace sinew::test
