/// `sinew figure` as a user meets it.

#include "tests/support/glb.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

class FigureCommand : public ProgramTest {};

TEST_F(FigureCommand, WritesAFileThatTheOtherCommandsTake) {
  const nlohmann::json made = json({"figure", "--like", "skeleton", "-o", "figure.glb"});
  EXPECT_EQ(made.at("file"), "figure.glb");
  EXPECT_NEAR(made.at("vertices").get<double>(), 1844, 0.02 * 1844);
  EXPECT_NEAR(made.at("triangles").get<double>(), 3342, 0.02 * 3342);
  EXPECT_EQ(made.at("joints"), 23);
  EXPECT_NEAR(made.at("height").get<double>(), 1.75, 1e-6);
  const nlohmann::json info = json({"info", "figure.glb"});
  EXPECT_EQ(info.at("vertices"), made.at("vertices"));
  EXPECT_EQ(info.at("triangles"), made.at("triangles"));
  EXPECT_EQ(info.at("joints"), 23);
  EXPECT_LE(info.at("max_influences"), 4);
  EXPECT_EQ(info.at("muscles").size(), 4u);
  EXPECT_EQ(info.at("humanoid").at("rightFoot"), "r_talocrural");
  EXPECT_EQ(json({"export", "figure.glb", "--rig", "-o", "rig.glb"}).at("vertices"), made.at("vertices"));
  EXPECT_EQ(json({"parity", "figure.glb", "--pose", "leftLowerArm=-90,0,0"}).at("pass"), true);
}

TEST_F(FigureCommand, AnOptionBesideThePresetCountsMore) {
  const nlohmann::json made = json({"figure", "--like", "woman", "--joints", "68", "--height", "1.8", "-o", "a.glb"});
  EXPECT_EQ(made.at("joints"), 68);
  EXPECT_NEAR(made.at("vertices").get<double>(), 2365, 0.02 * 2365);
  EXPECT_NEAR(made.at("height").get<double>(), 1.8, 1e-6);
  EXPECT_NEAR(json({"figure", "--like", "woman", "--vertices", "5000", "-o", "b.glb"}).at("vertices").get<double>(),
              5000, 100);
}

TEST_F(FigureCommand, TheSameWordsGiveTheSameBytes) {
  for (const char* name : {"one.glb", "other.glb"})
    ASSERT_EQ(run({"figure", "--sex", "0.4", "--build", "0.3", "-o", name}).exit_code, 0);
  EXPECT_EQ(read("one.glb"), read("other.glb"));
}

TEST_F(FigureCommand, WearsAHeadByAgeOrByMeasures) {
  const nlohmann::json made = json({"figure", "--like", "woman", "--head", "young", "-o", "actor.glb"});
  EXPECT_NEAR(made.at("height").get<double>(), 1.63, 1e-6);
  const nlohmann::json info = json({"info", "actor.glb"});
  EXPECT_EQ(info.at("vertices"), made.at("vertices"));
  EXPECT_EQ(info.at("morph_targets"), 111);
  EXPECT_EQ(info.at("muscles").size(), 4u);
  EXPECT_EQ(json({"parity", "actor.glb", "--pose", "head=0,40,0"}).at("pass"), true);
  ASSERT_EQ(run({"head", "--age", "young", "--save-measures", "young.json", "-o", "head.glb"}).exit_code, 0);
  ASSERT_EQ(run({"figure", "--like", "woman", "--head", "young.json", "-o", "by_file.glb"}).exit_code, 0);
  EXPECT_EQ(read("actor.glb"), read("by_file.glb"));
  const ProgramResult odd = run({"figure", "--head", "elderly", "-o", "x.glb"});
  EXPECT_EQ(odd.exit_code, 3) << odd;
  EXPECT_NE(odd.err.find("--head elderly"), std::string::npos) << odd;
  EXPECT_NE(odd.err.find("infant"), std::string::npos) << odd;
}

TEST_F(FigureCommand, OddOptionsAreWrongUsageAndNamed) {
  const std::vector<std::pair<Arguments, std::string>> odd{
      {{"--sex", "2"}, "--sex"},           {{"--sex", "nan"}, "--sex"},        {{"--height", "-1"}, "--height"},
      {{"--height", "0"}, "--height"},     {{"--height", "inf"}, "--height"},  {{"--build", "-1.5"}, "--build"},
      {{"--muscle", "nan"}, "--muscle"},   {{"--joints", "24"}, "--joints"},   {{"--vertices", "3"}, "--vertices"},
      {{"--vertices", "x"}, "--vertices"}, {{"--like", "sceleton"}, "--like"},
  };
  for (const auto& [words, named] : odd) {
    Arguments arguments{"figure", "-o", "figure.glb"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << result;
    EXPECT_NE(result.err.find(named), std::string::npos) << result;
  }
  EXPECT_EQ(run({"figure", "-o", "figure.obj"}).exit_code, 2);
  EXPECT_EQ(run({"figure"}).exit_code, 2);
  EXPECT_TRUE(names().empty());
}

TEST_F(FigureCommand, BecomesAVrmFile) {
  ASSERT_EQ(run({"figure", "--like", "woman", "-o", "woman.glb"}).exit_code, 0);
  const ProgramResult made =
      run({"export", "woman.glb", "--rig", "-o", "woman.vrm", "--meta", "authors=Ada", "--meta", "name=Woman"});
  ASSERT_EQ(made.exit_code, 0) << made;
  const nlohmann::json info = json({"info", "woman.vrm"});
  EXPECT_EQ(info.at("joints"), 37);
  EXPECT_EQ(info.at("humanoid").at("leftHand"), "l_radiocarpal");
  EXPECT_TRUE(info.at("problems").empty()) << info.at("problems");
  // In a T pose she is nearly as wide as tall.
  EXPECT_GT(info.at("bounds").at("max").at(0).get<double>(), 0.7);
  for (const Arguments& odd : {Arguments{"--rig", "-o", "x.vrm", "--meta", "nme=x"}, Arguments{"-o", "x.vrm"},
                               Arguments{"--rig", "-o", "x.glb", "--meta", "name=x"}}) {
    Arguments arguments{"export", "woman.glb"};
    arguments.insert(arguments.end(), odd.begin(), odd.end());
    EXPECT_EQ(run(arguments).exit_code, 2);
  }
  EXPECT_FALSE(names().contains("x.vrm"));
}

TEST_F(FigureCommand, WithAHeadHasEveryExpressionOfVrm) {
  ASSERT_EQ(run({"figure", "--like", "woman", "--head", "adult", "-o", "actor.glb"}).exit_code, 0);
  ASSERT_EQ(run({"export", "actor.glb", "--rig", "-o", "actor.vrm"}).exit_code, 0);
  const nlohmann::json gltf = glb_json(read("actor.vrm"));
  const nlohmann::json& expressions = gltf.at("extensions").at("VRMC_vrm").at("expressions");
  const nlohmann::json& preset = expressions.at("preset");
  for (const char* name : {"happy", "angry", "sad", "relaxed", "surprised", "aa", "ih", "ou", "ee", "oh", "blink",
                           "blinkLeft", "blinkRight", "lookUp", "lookDown", "lookLeft", "lookRight", "neutral"})
    EXPECT_TRUE(preset.contains(name)) << name;
  for (const auto& [name, expression] : preset.items())
    for (const nlohmann::json& bind : expression.at("morphTargetBinds")) {
      const auto mesh = gltf.at("nodes").at(bind.at("node").get<std::size_t>()).at("mesh").get<std::size_t>();
      EXPECT_EQ(gltf.at("meshes").at(mesh).at("extras").at("targetNames").at(bind.at("index").get<std::size_t>()), name);
    }
  // A laugh opens the mouth for itself: speech beside it would tear the lips.
  EXPECT_NE(expressions.at("custom").at("laugh").at("overrideMouth"), "none");
}

TEST_F(FigureCommand, OutputThatCannotBeWrittenIsSaid) {
  const ProgramResult result = run({"figure", "-o", "missing/figure.glb"});
  EXPECT_EQ(result.exit_code, 7) << result;
  EXPECT_NE(result.err.find("missing"), std::string::npos) << result;
}

}  // namespace
}  // namespace sinew::test
