/// sinew fit-skin: weights forgotten and found again.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/assets.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

using Json = nlohmann::json;

class FitSkin : public ProgramTest {
 protected:
  Json fit(const std::string& model, const Arguments& more = {}) const {
    Arguments words{"fit-skin", model, "--poses-from", model, "--random-poses", "20", "-o", path("fit.glb")};
    words.insert(words.end(), more.begin(), more.end());
    return json(words);
  }
  /// The promise: 0.01 % of the height clean; half a millimetre from a millimetre of noise.
  void expect_found(const std::string& model) const {
    const Json clean = fit(model);
    EXPECT_LE(clean["rmse"].get<double>(), 1e-4 * clean["height"].get<double>()) << clean.dump(1);
    EXPECT_LE(clean["max_influences"], 4);
    EXPECT_TRUE(clean["test_rmse"].is_null());
    EXPECT_EQ(json({"info", path("fit.glb")})["vertices"], json({"info", model})["vertices"]);
    const Json noisy = fit(model, {"--noise", "1", "--test-poses", "10"});
    EXPECT_LE(noisy["test_rmse"].get<double>(), 0.0005) << noisy.dump(1);
    EXPECT_NEAR(noisy["noise"].get<double>(), 0.001, 0.0001);
  }
};

TEST_F(FitSkin, FindsTheWeightsOfAProceduralFigure) {
  ASSERT_EQ(run({"figure", "--joints", "37", "-o", path("figure.glb")}).exit_code, 0);
  expect_found(path("figure.glb"));
}

TEST_F(FitSkin, FindsTheWeightsOfRealCharacters) {
  SINEW_ASSETS_OR_SKIP(assets);
  expect_found((assets / "characters/khronos/CesiumMan.glb").string());
}

TEST_F(FitSkin, TheReportHoldsWhatScriptsRead) {
  const Json report = fit(arm());
  for (const char* key : {"vertices", "poses", "bones", "max_influences", "rmse", "max_error", "relative_rmse",
                          "test_rmse", "ms", "worst", "shells", "reasons"})
    EXPECT_TRUE(report.contains(key)) << key;
  EXPECT_EQ(report["poses"], 20);
  EXPECT_EQ(report["worst"].size(), 10u);
  EXPECT_GE(report["max_error"].get<double>(), report["worst"][0]["rmse"].get<double>());
  const Json again = fit(arm());
  EXPECT_EQ(report["rmse"], again["rmse"]);
}

/// The arm that curls, as files: its rest, a mesh a frame, and all frames in one.
class FitSkinFiles : public FitSkin {
 protected:
  void SetUp() override {
    ASSERT_EQ(run({"fit-skin", arm(), "--poses-from", arm(), "--random-poses", "6", "-o", path("rig.glb")}).exit_code,
              0);
    write("curl.json", R"({"sinew": 1, "fps": 24, "frames": [0, 9], "characters": [{"model": "rig.glb", "muscles": [],
      "keys": {"leftLowerArm": [[0, [0, 0, 0]], [9, [0, -100, 20]]], "leftUpperArm": [[0, [0, 0, 0]], [9, [30, 0, 40]]],
               "leftHand": [[0, [0, 0, 0]], [5, [0, 0, 50]], [9, [0, 30, 0]]]}}]})");
    ASSERT_EQ(run({"export", "curl.json", "--by", "cpu", "-o", "pose_##.obj"}).exit_code, 0);
    ASSERT_EQ(run({"export", "curl.json", "--frames", "0-9", "--by", "cpu", "-o", "baked.glb"}).exit_code, 0);
    ASSERT_EQ(run({"export", "rig.glb", "--by", "cpu", "-o", "rest.ply"}).exit_code, 0);
    for (int i = 0; i < 10; ++i) poses.push_back(fmt::format("pose_{:02}.obj", i));
  }
  Arguments with_poses(const Arguments& before, const Arguments& after) const {
    Arguments words = before;
    words.insert(words.end(), poses.begin(), poses.end());
    words.insert(words.end(), after.begin(), after.end());
    return words;
  }
  Arguments poses;
};

TEST_F(FitSkinFiles, BonesAreFoundInMeshFiles) {
  const Json found =
      json(with_poses({"fit-skin", "rest.ply"}, {"--bones", "unknown", "--count", "3", "-o", "found.glb"}));
  EXPECT_EQ(found["poses"], 10);
  EXPECT_EQ(found["bones"], 3);
  EXPECT_LE(found["rmse"].get<double>(), 0.005 * found["height"].get<double>()) << found.dump(1);
  const Json info = json({"info", "found.glb"});
  EXPECT_EQ(info["joints"], 3);
  EXPECT_EQ(info["clips"][0]["name"], "found");
  EXPECT_EQ(info["vertices"], found["vertices"]);
}

TEST_F(FitSkinFiles, KnownBonesExplainTheirOwnClip) {
  // The bones that were found have a clip: their weights can be forgotten and found from it, by mesh files or a film.
  ASSERT_EQ(
      run(with_poses({"fit-skin", "rest.ply"}, {"--bones", "unknown", "--count", "3", "-o", "found.glb"})).exit_code,
      0);
  ASSERT_EQ(run({"export", "found.glb", "--frames", "0-9", "--by", "cpu", "-o", "again_##.ply"}).exit_code, 0);
  Arguments words{"fit-skin", "rest.ply"};
  for (int i = 0; i < 10; ++i) words.push_back(fmt::format("again_{:02}.ply", i));
  words.insert(words.end(), {"--skeleton", "found.glb", "-o", "fit.glb"});
  // Places were rounded to floats on the way: 1e-7 of the size.
  EXPECT_LE(json(words)["relative_rmse"].get<double>(), 1e-6);
  const Json own = json({"fit-skin", "rest.ply", "found.glb", "-o", "own.glb"});
  EXPECT_LE(own["relative_rmse"].get<double>(), 1e-6);
  EXPECT_EQ(own["poses"], 10);
  EXPECT_LE(
      json({"fit-skin", "rest.ply", "baked.glb", "--skeleton", "found.glb", "-o", "baked_fit.glb"})["relative_rmse"]
          .get<double>(),
      0.005);
}

TEST_F(FitSkinFiles, BadPosesAreNamed) {
  const auto fails = [&](const Arguments& words, const std::string& says) {
    const ProgramResult result = run(words);
    EXPECT_EQ(result.exit_code, 3) << result;
    EXPECT_NE(result.err.find(says), std::string::npos) << result;
  };
  fails(with_poses({"fit-skin", "rest.ply"}, {"-o", "x.glb"}), "--skeleton");
  fails(with_poses({"fit-skin", "rest.ply"}, {"--skeleton", "rig.glb", "-o", "x.glb"}), "no clip");
  fails(with_poses({"fit-skin", "rest.ply"}, {"--bones", "unknown", "--count", "1000", "-o", "x.glb"}),
        "more than can be told apart");
  write("other.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  fails({"fit-skin", "rest.ply", "pose_00.obj", "other.obj", "--bones", "unknown", "--count", "2", "-o", "x.glb"},
        "other.obj: has 3 vertices");
  write("nan.obj", "v 0 0 0\nv nan 0 0\n");
  fails({"fit-skin", "rest.ply", "nan.obj", "--bones", "unknown", "--count", "2", "-o", "x.glb"}, "line 2");
  fails({"fit-skin", "rest.ply", "rig.glb", "--bones", "unknown", "--count", "2", "-o", "x.glb"}, "not animated");
  // The same counts, other triangles.
  const Bytes first = read("pose_00.obj");
  std::string text(first.begin(), first.end());
  const std::size_t face = text.find("\nf ");
  text.replace(face + 3, text.find(' ', face + 3) - face - 3, "1/1/1");
  write("twisted.obj", text);
  fails({"fit-skin", "rest.ply", "twisted.obj", "--bones", "unknown", "--count", "1", "-o", "x.glb"}, "joins vertices");
  EXPECT_FALSE(names().contains("x.glb"));
}

TEST_F(FitSkin, WordsThatDoNotGoTogether) {
  const auto code = [&](const Arguments& words) { return run(words).exit_code; };
  EXPECT_EQ(code({"fit-skin", "a.obj", "b.obj", "--test-poses", "2", "-o", "x.glb"}), 2);
  EXPECT_EQ(code({"fit-skin", "a.obj", "b.obj", "--bones", "unknown", "-o", "x.glb"}), 2);
  EXPECT_EQ(code({"fit-skin", "a.obj", "b.obj", "--count", "4", "-o", "x.glb"}), 2);
  EXPECT_EQ(code({"fit-skin", "a.obj", "b.obj", "--bones", "some", "-o", "x.glb"}), 2);
  EXPECT_EQ(
      code({"fit-skin", "a.obj", "b.obj", "--bones", "unknown", "--count", "4", "--skeleton", "s.glb", "-o", "x.glb"}),
      2);
  EXPECT_EQ(code({"fit-skin", "a.glb", "--poses-from", "b.glb", "--random-poses", "2", "--clip", "0", "-o", "x.glb"}),
            2);
}

TEST_F(FitSkin, WrongUsageAndBadInput) {
  const std::string model = arm();
  const auto code = [&](const Arguments& words) { return run(words).exit_code; };
  EXPECT_EQ(code({"fit-skin", model, "-o", path("x.glb")}), 2);
  EXPECT_EQ(code({"fit-skin", model, "--poses-from", model, "-o", path("x.glb")}), 2);
  const Arguments base{"fit-skin", model, "--poses-from", model, "--random-poses", "2"};
  const auto with = [&](const Arguments& more) {
    Arguments words = base;
    words.insert(words.end(), more.begin(), more.end());
    return code(words);
  };
  EXPECT_EQ(with({"-o", path("x.obj")}), 2);
  EXPECT_EQ(with({"-o", path("x.glb"), "--influences", "9"}), 2);
  EXPECT_EQ(with({"-o", path("x.glb"), "--method", "guess"}), 2);
  EXPECT_EQ(with({"-o", model}), 7);
  EXPECT_EQ(code({"fit-skin", path("none.glb"), "--poses-from", model, "--random-poses", "2", "-o", path("x.glb")}), 3);
  ASSERT_EQ(code({"export", model, "--frame", "0", "-o", path("baked.glb")}), 0);
  const ProgramResult unskinned =
      run({"fit-skin", path("baked.glb"), "--poses-from", model, "--random-poses", "2", "-o", path("x.glb")});
  EXPECT_EQ(unskinned.exit_code, 3);
  EXPECT_FALSE(names().contains("x.glb"));
}

}  // namespace
}  // namespace sinew::test
