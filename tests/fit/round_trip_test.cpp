/// Characters whose weights are forgotten and found again.

#include "engine/fit/round_trip.h"

#include <gtest/gtest.h>

#include "engine/body/figure.h"
#include "engine/io/gltf_read.h"
#include "tests/support/assets.h"
#include "tests/support/tube.h"

namespace sinew::test {
namespace {

FitReport round_trip(const Model& model, const RoundTripOptions& options) {
  Model rest = model;
  const auto report = fit_round_trip(model, options, rest);
  EXPECT_TRUE(report) << report.error().message;
  return report ? *report : FitReport{};
}

void record(const std::string& name, double value) {
  testing::Test::RecordProperty(name, fmt::format("{:.4g}", value));
}

/// 0.01 % of the height clean; half a millimetre from a millimetre of noise.
void expect_found(const Model& model) {
  RoundTripOptions options;
  options.test_poses = 10;
  const FitReport clean = round_trip(model, options);
  record("vertices", static_cast<double>(clean.vertices));
  record("bones", static_cast<double>(clean.bones));
  record("clean_share_of_height", clean.rmse / clean.height);
  record("clean_test_share_of_height", clean.test_rmse / clean.height);
  record("clean_microseconds_a_vertex", 1e3 * clean.milliseconds / static_cast<double>(clean.vertices));
  EXPECT_LE(clean.rmse, 1e-4 * clean.height);
  EXPECT_LE(clean.max_influences, 4u);
  options.noise = 1.0;
  const FitReport noisy = round_trip(model, options);
  record("noise_seen", noisy.noise);
  record("noisy_test_rmse", noisy.test_rmse);
  record("noisy_microseconds_a_vertex", 1e3 * noisy.milliseconds / static_cast<double>(noisy.vertices));
  EXPECT_LE(noisy.test_rmse, 0.0005);
  options.method = FitMethod::paper;
  record("paper_noisy_test_rmse", round_trip(model, options).test_rmse);
  options.noise = 0.0;
  const FitReport paper = round_trip(model, options);
  record("paper_clean_share_of_height", paper.rmse / paper.height);
  record("paper_clean_test_share_of_height", paper.test_rmse / paper.height);
}

Model read_model(const std::filesystem::path& file) {
  auto model = read_gltf(file);
  EXPECT_TRUE(model) << model.error().message;
  return model ? *model : Model{};
}

TEST(RoundTrip, FindsTheWeightsOfAFigure) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "SKIPPED: minutes under the sanitizers, where smaller cases run";
#endif
  BodyOptions options;
  options.joints = 68;
  const auto model = build_figure(options);
  ASSERT_TRUE(model) << model.error().message;
  expect_found(*model);
}

TEST(RoundTrip, FindsTheWeightsOfCesiumMan) {
  SINEW_ASSETS_OR_SKIP(assets);
  expect_found(read_model(assets / "characters/khronos/CesiumMan.glb"));
}

TEST(RoundTrip, FindsTheWeightsOfAMakeHumanCharacter) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "SKIPPED: minutes under the sanitizers, where smaller cases run";
#endif
  SINEW_ASSETS_OR_SKIP(assets);
  expect_found(read_model(assets / "characters/makehuman/mh_male_game.glb"));
}

TEST(RoundTrip, ReportsTheWorstAndEveryShell) {
  Model rest = tube();
  RoundTripOptions options;
  options.poses = 4;
  options.noise = 1.0;
  const auto report = fit_round_trip(tube(), options, rest);
  ASSERT_TRUE(report) << report.error().message;
  ASSERT_EQ(report->worst.size(), 10u);
  for (std::size_t i = 1; i < 10; ++i) EXPECT_GE(report->worst[i - 1].rmse, report->worst[i].rmse);
  ASSERT_EQ(report->shells.size(), 1u);
  EXPECT_EQ(report->shells[0].mesh, "tube");
  EXPECT_DOUBLE_EQ(report->shells[0].rmse, report->rmse);
  EXPECT_EQ(report->vertices, rest.meshes[0].primitives[0].influences.vertices());
}

TEST(RoundTrip, OtherTopologyAndNoSkeletonAreToldApart) {
  Model other = tube({.rows = 9});
  const auto topology = fit_round_trip(tube(), {}, other);
  ASSERT_FALSE(topology);
  EXPECT_NE(topology.error().message.find("expected the same topology"), std::string::npos);
  Model bare = tube();
  bare.nodes[tube_skin].skin = -1;
  const auto skeleton = fit_round_trip(tube(), {}, bare);
  ASSERT_FALSE(skeleton);
  EXPECT_NE(skeleton.error().message.find("nothing in it is skinned"), std::string::npos);
  EXPECT_EQ(skeleton.error().kind, ErrorKind::bad_input);
}

}  // namespace
}  // namespace sinew::test
