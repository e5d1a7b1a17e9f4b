/// sinew fit-skin: weights forgotten and found again.

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
