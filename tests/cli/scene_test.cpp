/// Scene files as a user writes them, from any folder.

#include "tests/support/program.h"

namespace sinew::test {
namespace {

class SceneFile : public ProgramTest {
 protected:
  /// Of the picture of one frame.
  std::string shot(const std::string& scene, const std::string& frame, const ProgramOptions& options = {}) const {
    Arguments all{"render", "--frame", frame, "--size", "160x90", "-o", path("shot.png"), "--json"};
    if (!scene.empty()) all.insert(all.begin() + 1, scene);
    const ProgramResult result = run(all, options);
    EXPECT_EQ(result.exit_code, 0) << result;
    return json_of(result)["frames"][0]["sha256"];
  }
  /// Of the picture's points alone: the recipe in the file differs where the scene's words do.
  Bytes pixels(const std::string& scene, const std::string& frame) const {
    shot(scene, frame);
    return picture("shot.png").rgba;
  }
};

TEST_F(SceneFile, TheEmbeddedSceneIsTheOneBesideTheSource) {
  EXPECT_EQ(shot("", "20"), shot(std::string(SINEW_SOURCE_DIR) + "/scenes/curl.json", "20"));
}

TEST_F(SceneFile, KeysMoveTheJoint) {
  arm();
  write("keys.json", R"({ "sinew": 1, "fps": 24, "frames": [0, 24], // a remark
    "characters": [{"model": "arm.glb", "keys": {"leftLowerArm": [[0, [0, 0, 0]], [24, [0, -120, 0]]]}}]})");
  EXPECT_EQ(json({"info", "keys.json"})["frames"], nlohmann::json({0, 24}));
  EXPECT_NE(pixels("keys.json", "0"), pixels("keys.json", "24"));
  // Keys are held after the last, and halfway between two is the half of both.
  EXPECT_EQ(pixels("keys.json", "24"), pixels("keys.json", "99"));
  const auto exported = [&](const Arguments& more) {
    Arguments all{"export", "-o", "x.ply"};
    all.insert(all.end(), more.begin(), more.end());
    EXPECT_EQ(run(all).exit_code, 0);
    return read("x.ply");
  };
  EXPECT_EQ(exported({"keys.json", "--frame", "12"}),
            exported({"keys.json", "--frame", "0", "--pose", "leftLowerArm=0,-60,0"}));
}

TEST_F(SceneFile, EaseShapesTheWayBetweenKeys) {
  arm();
  const auto halfway = [&](const std::string& keys, const std::string& frame) {
    write("ease.json", R"({"sinew": 1, "frames": [0, 24], "characters": [{"model": "arm.glb",
                           "keys": {"leftLowerArm": )" +
                           keys + "}}]}");
    EXPECT_EQ(run({"export", "ease.json", "--frame", frame, "-o", "x.ply"}).exit_code, 0);
    return read("x.ply");
  };
  const std::string list = "[[0, [0, 0, 0]], [24, [0, -120, 0]]]";
  const auto eased = [&](const std::string& ease) { return R"({"ease": ")" + ease + R"(", "keys": )" + list + "}"; };
  EXPECT_EQ(halfway(eased("linear"), "6"), halfway(list, "6"));
  EXPECT_NE(halfway(eased("smooth"), "6"), halfway(list, "6"));
  EXPECT_EQ(halfway(eased("step"), "23"), halfway(list, "0"));
  EXPECT_EQ(halfway(eased("step"), "24"), halfway(list, "24"));
}

/// The muscle of `info` as a scene writes it.
nlohmann::json explicit_form(nlohmann::json muscle) {
  for (const char* found : {"centre", "region_vertices", "segment_vertices"}) muscle.erase(found);
  return muscle;
}

TEST_F(SceneFile, MuscleByPresetAndInFullAreTheSame) {
  arm();
  const auto scene = [&](const nlohmann::json& muscle) {
    return nlohmann::json{{"sinew", 1},
                          {"frames", {0, 47}},
                          {"characters",
                           {{{"model", "arm.glb"},
                             {"muscles", {muscle}},
                             {"keys", {{"leftLowerArm", {{0, {0, 0, 0}}, {47, {0, -130, 0}}}}}}}}}}
        .dump();
  };
  write("preset.json", scene({{"preset", "biceps"}, {"side", "left"}}));
  const auto resolved = json({"info", "preset.json"})["muscles"];
  ASSERT_EQ(resolved.size(), 1u);
  write("full.json", scene(explicit_form(resolved[0])));
  EXPECT_EQ(json({"info", "full.json"})["muscles"], resolved);
  EXPECT_EQ(pixels("full.json", "47"), pixels("preset.json", "47"));

  write("higher.json", scene({{"preset", "biceps"}, {"side", "left"}, {"peak", 0.02}, {"name", "mine"}}));
  auto expected = resolved;
  expected[0]["peak"] = 0.02;
  expected[0]["name"] = "mine";
  EXPECT_EQ(json({"info", "higher.json"})["muscles"], expected)
      << "a key beside the preset takes its place, and no other";
  EXPECT_NE(pixels("higher.json", "47"), pixels("preset.json", "47"));
}

TEST_F(SceneFile, PathsAreThoseOfTheSceneAndNotOfTheUser) {
  arm();
  std::filesystem::create_directories(path("project/models"));
  std::filesystem::create_directories(path("elsewhere"));
  std::filesystem::rename(path("arm.glb"), path("project/models/arm.glb"));
  write("project/scenes/a.json", R"({"sinew": 1, "characters": [{"model": "../models/arm.glb"}]})");
  const std::string from_above = shot("project/scenes/a.json", "0");
  EXPECT_EQ(shot("a.json", "0", {.folder = path("project/scenes")}), from_above);
  EXPECT_EQ(shot("../project/scenes/a.json", "0", {.folder = path("elsewhere")}), from_above);
  EXPECT_EQ(shot(path("project/scenes/a.json"), "0", {.folder = "/"}), from_above);
}

TEST_F(SceneFile, TheProgramRunsFromAnyFolder) {
  const std::string here = shot("", "0");
  for (const char* folder : {"/", "/usr", "/proc/self"}) EXPECT_EQ(shot("", "0", {.folder = folder}), here) << folder;
  EXPECT_EQ(shot("", "0", {.environment = {{"HOME", std::nullopt}, {"XDG_CACHE_HOME", "/nonexistent"}}}), here);
}

TEST_F(SceneFile, NamesWithSpacesAndUmlauts) {
  arm();
  std::filesystem::rename(path("arm.glb"), path("ein schöner Arm.glb"));
  write("scène un.json", R"({"sinew": 1, "characters": [{"model": "ein schöner Arm.glb"}]})");
  shot("scène un.json", "0");
}

TEST_F(SceneFile, SeveralCharactersStandWhereTheyArePut) {
  arm();
  write("two.json", R"({"sinew": 1, "characters": [{"model": "arm.glb"},
                        {"model": "arm.glb", "position": [0, 1, 0], "turn": 90}]})");
  const auto one = json({"info", "arm.glb"}), two = json({"info", "two.json"});
  EXPECT_EQ(two["characters"], 2);
  for (const char* key : {"vertices", "triangles", "joints"}) EXPECT_EQ(two[key], 2 * one[key].get<int>()) << key;
  EXPECT_NEAR(two["bounds"]["max"][1], 1.0 + one["bounds"]["max"][1].get<double>(), 1e-6);
  EXPECT_EQ(json({"parity", "two.json"})["vertices"], two["vertices"]);
}

TEST_F(SceneFile, CameraAndLookAreTheScenes) {
  arm();
  write("look.json", R"({"sinew": 1, "characters": [{"model": "arm.glb"}], "camera": {"view": "top", "orbit": 20},
                         "look": {"shading": "normals", "background": "#112233"}})");
  write("plain.json", R"({"sinew": 1, "characters": [{"model": "arm.glb"}]})");
  const Bytes from_scene = pixels("look.json", "0");
  EXPECT_EQ((Bytes(from_scene.begin(), from_scene.begin() + 3)), (Bytes{0x11, 0x22, 0x33}));
  ASSERT_EQ(run({"render", "plain.json", "--view", "top", "--orbit", "20", "--shading", "normals", "--background",
                 "#112233", "--size", "160x90", "-o", "x.png"})
                .exit_code,
            0);
  EXPECT_EQ(picture("x.png").rgba, from_scene);
}

}  // namespace
}  // namespace sinew::test
