/// sinew muscles, and what info measures.

#include <fstream>

#include <gtest/gtest.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "tests/support/assets.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

using Json = nlohmann::json;

class Muscles : public ProgramTest {
 protected:
  Json scene(const std::string& name) const {
    const Bytes bytes = read(name);
    return Json::parse(bytes.begin(), bytes.end());
  }

  static bool fits_the_schema(const Json& scene) {
    std::ifstream in(std::string(SINEW_SOURCE_DIR) + "/scenes/scene.schema.json");
    const Json document = Json::parse(in);
    valijson::Schema schema;
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(valijson::adapters::NlohmannJsonAdapter(document), schema);
    valijson::Validator validator(valijson::Validator::kStrongTypes);
    return validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(scene), nullptr);
  }
};

TEST_F(Muscles, WritesASceneThatShowsTheBareModel) {
  SINEW_ASSETS_OR_SKIP(assets);
  const std::string model = (assets / "characters/mesh2motion/human-zombie.glb").string();
  std::filesystem::create_directory(path("below"));
  const Json report = json({"muscles", model, "-o", "below/zombie.json"});
  ASSERT_EQ(report["muscles"].size(), 4u);
  const Json written = scene("below/zombie.json");
  EXPECT_TRUE(fits_the_schema(written)) << written;
  for (const Json& muscle : written["characters"][0]["muscles"]) {
    EXPECT_FALSE(muscle.contains("preset"));
    for (const char* key : {"name", "bone", "child", "driver", "tip", "facing", "from", "to", "spread", "peak", "sigma",
                            "rest_angle", "reference_angle"})
      EXPECT_TRUE(muscle.contains(key)) << key;
  }
  const std::filesystem::path named = written["characters"][0]["model"].get<std::string>();
  EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(path("below")) / named)) << named;
  for (const std::string& what : {model, std::string("below/zombie.json")}) {
    const ProgramResult drawn = run({"render", what, "--frame", "7", "--size", "160x120", "--pose",
                                     "leftLowerArm=0,-90,0", "-o", what == model ? "bare.png" : "scene.png"});
    ASSERT_EQ(drawn.exit_code, 0) << drawn;
  }
  const Json same = json({"compare", "bare.png", "scene.png"});
  EXPECT_EQ(same["pixels_over"], 0) << "the same picture";
}

TEST_F(Muscles, OneThatIsOffIsAsIfItWereNotThere) {
  const auto scene = [&](const std::string& muscles) {
    return R"({"sinew": 1, "frames": [0, 3], "characters": [{"model": "builtin:arm", "muscles": [)" + muscles +
           R"(], "keys": {"leftLowerArm": [[0, [0, 0, 0]], [3, [0, -120, 0]]]}}]})";
  };
  const std::string behind = R"({"preset": "biceps", "side": "left", "name": "behind", "facing": [0, 0, -1]})",
                    biceps = R"({"preset": "biceps", "side": "left")";
  write("on.json", scene(behind + "," + biceps + "}"));
  write("off.json", scene(behind + "," + biceps + R"(, "on": false})"));
  write("without.json", scene(behind));
  for (const std::string name : {"on", "off", "without"}) {
    for (const std::string by : {"gpu", "cpu"}) {
      const ProgramResult out = run({"export", name + ".json", "--frame", "3", "--by", by, "-o", name + by + ".ply"});
      ASSERT_EQ(out.exit_code, 0) << out;
    }
    for (const std::string shading : {"lit", "bulge"}) {
      const ProgramResult drawn = run({"render", name + ".json", "--frame", "3", "--size", "320x240", "--shading",
                                       shading, "-o", name + shading + ".png"});
      ASSERT_EQ(drawn.exit_code, 0) << drawn;
    }
  }
  for (const std::string file : {"gpu.ply", "cpu.ply"}) {
    EXPECT_TRUE(read("off" + file) == read("without" + file)) << file;
    EXPECT_FALSE(read("off" + file) == read("on" + file)) << file;
  }
  for (const std::string file : {"lit.png", "bulge.png"}) {
    EXPECT_TRUE(picture("off" + file).rgba == picture("without" + file).rgba) << file;
    EXPECT_FALSE(picture("off" + file).rgba == picture("on" + file).rgba) << file;
  }
  EXPECT_TRUE(json({"parity", "off.json"})["pass"]);
  const Json listed = json({"info", "off.json", "--pose", "leftLowerArm=0,-120,0"})["muscles"];
  ASSERT_EQ(listed.size(), 2u) << "it is still there";
  EXPECT_EQ(listed[1]["on"], false);
  EXPECT_EQ(listed[1]["activation"], 0.0);
  EXPECT_GT(listed[1]["region_vertices"], 0);
}

TEST_F(Muscles, StrengthScalesThePeaks) {
  SINEW_ASSETS_OR_SKIP(assets);
  const std::string model = (assets / "characters/makehuman/mh_male_game.glb").string();
  const Json whole = json({"muscles", model, "-o", "x.json"}),
             half = json({"muscles", model, "-o", "x.json", "--strength", "0.5"});
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_DOUBLE_EQ(half["muscles"][i]["peak"].get<double>(), 0.5 * whole["muscles"][i]["peak"].get<double>());
}

TEST_F(Muscles, PresetsAreChosen) {
  SINEW_ASSETS_OR_SKIP(assets);
  const std::string model = (assets / "characters/makehuman/mh_male_game.glb").string();
  const Json two = json({"muscles", model, "-o", "x.json", "--preset", "triceps", "--preset", "pectoral"});
  ASSERT_EQ(two["muscles"].size(), 4u);
  EXPECT_EQ(two["muscles"][0]["name"], "triceps_left");
  EXPECT_EQ(two["muscles"][3]["name"], "pectoral_right");
  EXPECT_TRUE(fits_the_schema(scene("x.json")));
  EXPECT_EQ(json({"muscles", model, "-o", "x.json", "--all"})["muscles"].size(), 16u);
  EXPECT_TRUE(fits_the_schema(scene("x.json")));
  EXPECT_EQ(json({"info", "x.json"})["muscles"].size(), 16u);
  EXPECT_EQ(run({"muscles", model, "-o", "x.json", "--preset", "bisceps"}).exit_code, 2);
  EXPECT_EQ(run({"muscles", model, "-o", "x.json", "--all", "--preset", "calf"}).exit_code, 2);
  EXPECT_EQ(run({"muscles", model, "-o", "x.json", "--strength", "1.5"}).exit_code, 2);
  EXPECT_EQ(run({"muscles", model}).exit_code, 2);
}

TEST_F(Muscles, WhatIsNoHumanoidIsRefusedAndNothingWritten) {
  SINEW_ASSETS_OR_SKIP(assets);
  const auto in = [&](const char* file) { return (assets / "characters" / file).string(); };
  for (const auto& [model, says] : {std::pair(in("khronos/Fox.glb"), "four legs"),
                                    {in("khronos/RiggedSimple.glb"), "no humanoid joints"},
                                    {in("khronos/SimpleSkin.gltf"), "leftUpperArm"},
                                    {in("godot_hand/LeftHandHumanoid.gltf"), "leftUpperArm"},
                                    {std::string("builtin:arm"), "leftLowerLeg"}}) {
    for (const char* which : {"--quiet", "--all"}) {
      if (model == "builtin:arm" && std::string(which) == "--all") continue;  // it has a biceps
      const ProgramResult result = run({"muscles", model, "-o", "x.json", which});
      EXPECT_EQ(result.exit_code, 3) << result;
      EXPECT_NE(result.err.find(says), std::string::npos) << result;
      EXPECT_TRUE(names().empty()) << model;
    }
  }
  const ProgramResult arm = run({"muscles", "builtin:arm", "-o", "x.json", "--preset", "biceps"});
  EXPECT_EQ(arm.exit_code, 0) << arm;
  EXPECT_NE(arm.err.find("rightUpperArm"), std::string::npos) << "what it lacks is said: " << arm;
}

TEST_F(Muscles, InfoMeasures) {
  SINEW_ASSETS_OR_SKIP(assets);
  const std::string model = (assets / "characters/makehuman/mh_male_game.glb").string();
  const Json rest = json({"info", model, "--girth", "leftUpperArm", "--volume", "leftUpperArm"});
  EXPECT_EQ(rest["girth"]["joint"], "leftUpperArm");
  EXPECT_EQ(rest["girth"]["at"], 0.5);
  const double tape = rest["girth"]["tape"];
  EXPECT_GT(tape, 0.25) << "a man's arm, metres";
  EXPECT_LT(tape, 0.40);
  EXPECT_GE(rest["girth"]["length"].get<double>(), tape);
  EXPECT_GT(rest["volume"]["volume"].get<double>(), 0.0008) << "cubic metres";
  EXPECT_LT(rest["volume"]["volume"].get<double>(), 0.003);
  EXPECT_EQ(rest["volume"]["open_edges"], 0);
  const Json flexed = json({"info", model, "--girth", "leftUpperArm", "--pose", "leftLowerArm=-99.86,-34.76,52.77"});
  EXPECT_GT(flexed["girth"]["tape"].get<double>(), 1.02 * tape) << "the biceps is at work";
  EXPECT_EQ(run({"info", model, "--girth", "leftUpperArn"}).exit_code, 3);
  EXPECT_EQ(run({"info", model, "--girth", "head"}).exit_code, 3) << "no joint after it";
  EXPECT_EQ(run({"info", model, "--girth", "leftUpperArm", "--at", "1.5"}).exit_code, 2);
  EXPECT_EQ(run({"info", model, "--at", "0.5"}).exit_code, 2) << "of what";
}

TEST_F(Muscles, PeopleGetATable) {
  SINEW_ASSETS_OR_SKIP(assets);
  const std::string out = run({"info", (assets / "characters/makehuman/mh_male_game.glb").string()}).out;
  EXPECT_EQ(out.find("\"region_vertices\""), std::string::npos);
  const std::size_t header = out.find("  muscle "), row = out.find("  calf_left ");
  ASSERT_NE(header, std::string::npos) << out;
  ASSERT_NE(row, std::string::npos) << out;
  const auto line = [&](std::size_t at) { return out.substr(at, out.find('\n', at) - at); };
  EXPECT_EQ(line(header).find("segment"), line(row).find("calf_l ")) << "aligned:\n" << out;
}

}  // namespace
}  // namespace sinew::test
