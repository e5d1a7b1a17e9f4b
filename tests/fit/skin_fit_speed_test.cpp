/// How fast weights are found, on a case like the one by which others are known: a chain of bones in 20 poses of random
/// angles up to 25 degrees, four influences a vertex. The table in engine/definitions.md 16 comes from here.

#include <ctime>

#include <gtest/gtest.h>

#include "engine/fit/random_poses.h"
#include "engine/fit/rigid_bones.h"
#include "engine/fit/skin_fit.h"
#include "engine/fit/skinned_shape.h"
#include "engine/fit/weight_run.h"

namespace sinew::test {
namespace {

constexpr std::size_t poses = 20;

/// A tube of length 2 along +Y round a chain of bones; each vertex follows the four nearest, by a bell of their
/// distance.
struct Chain {
  Chain(std::size_t rows, std::size_t columns, std::size_t bone_count) : bones(bone_count, poses) {
    const double length = 2.0 / static_cast<double>(bone_count);
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t column = 0; column < columns; ++column) {
        const double y = 2.0 * static_cast<double>(row) / static_cast<double>(rows - 1);
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(column) / static_cast<double>(columns);
        rest.emplace_back(0.1 * std::sin(angle), y, 0.1 * std::cos(angle));
        std::vector<Influence> weights;
        for (std::uint32_t b = 0; b < bone_count; ++b) {
          const double off = (y - (b + 0.5) * length) / length;
          weights.push_back({b, std::exp(-0.5 * off * off)});
        }
        truth.add_vertex(weight_run(std::move(weights), 4));
        if (row + 1 == rows) continue;
        const auto a = static_cast<std::uint32_t>(row * columns + column);
        const auto b = static_cast<std::uint32_t>(row * columns + (column + 1) % columns);
        const auto up = static_cast<std::uint32_t>(columns);
        triangles.insert(triangles.end(), {a, b, a + up, a + up, b, b + up});
      }
    RandomNumbers random(11);
    for (std::size_t k = 0; k < poses; ++k) {
      Mat4 above(1.0);
      for (std::size_t b = 0; b < bone_count; ++b) {
        const Vec3 degrees(50.0 * random.uniform() - 25.0, 50.0 * random.uniform() - 25.0,
                           50.0 * random.uniform() - 25.0);
        const Vec3 joint(0.0, length * static_cast<double>(b), 0.0);
        above = above * Transform{joint, rotation_xyz_degrees(degrees), Vec3(1.0)}.matrix() *
                Transform{-joint, {1, 0, 0, 0}, Vec3(1.0)}.matrix();
        bones.at(b, k) = Mat34::from(above);
      }
    }
    posed = skinned_places(rest, truth, bones);
    for (const Vec3& p : rest) bounds.add(p);
  }

  void add_noise(double sigma) {
    RandomNumbers random(12);
    for (Vec3& place : posed)
      for (int i = 0; i < 3; ++i) place[i] += sigma * random.normal();
  }
  double relative_rmse(const Influences& influences, const BonePoses& by) const {
    const std::vector<Vec3> found = skinned_places(rest, influences, by);
    double squared = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) squared += glm::dot(found[i] - posed[i], found[i] - posed[i]);
    return std::sqrt(squared / static_cast<double>(found.size())) / bounds.diagonal();
  }

  std::vector<Vec3> rest, posed;
  std::vector<std::uint32_t> triangles;
  Influences truth;
  BonePoses bones;
  Bounds bounds;
};

/// Of all threads: half of it is what two cores take, whatever else they do.
double processor_seconds_since(std::clock_t begin) {
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

struct Case {
  std::size_t rows, columns, bones;
};

class SkinFitSpeed : public testing::TestWithParam<Case> {};

TEST_P(SkinFitSpeed, AChain) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "SKIPPED: a matter of speed";
#endif
  const Case& size = GetParam();
  Chain chain(size.rows, size.columns, size.bones);
  const auto fit = [&](FitMethod method, double& microseconds) {
    const SkinFitJob job{chain.rest, chain.posed, chain.triangles, chain.bones, method, 4};
    SkinFitReport report;
    const std::clock_t begin = std::clock();
    const Influences found = job.run(report).value();
    microseconds = 0.5e6 * processor_seconds_since(begin) / static_cast<double>(chain.rest.size());
    return found;
  };
  double ours = 0.0, papers = 0.0, noisy = 0.0;
  const double clean = chain.relative_rmse(fit(FitMethod::convex, ours), chain.bones);
  const double paper = chain.relative_rmse(fit(FitMethod::paper, papers), chain.bones);
  chain.add_noise(1e-3 * chain.bounds.diagonal());
  const double with_noise = chain.relative_rmse(fit(FitMethod::convex, noisy), chain.bones);
  fmt::print("{} vertices, {} bones: {:.0f} us a vertex, {:.2g}; paper {:.0f} us, {:.2g}; noisy {:.0f} us, {:.3g}\n",
             chain.rest.size(), size.bones, ours, clean, papers, paper, noisy, with_noise);
  EXPECT_LE(clean, 1e-5);
  // The noise has a 3-D length of sqrt(3) sigma, of which four free weights take a part away.
  EXPECT_LE(with_noise, 1.74e-3);
  // 165 is asked for on two cores that do nothing else. How fast it is is told, not tested: others share the machine.
  RecordProperty("microseconds_a_vertex", std::to_string(ours));
}

INSTANTIATE_TEST_SUITE_P(Chains, SkinFitSpeed,
                         testing::Values(Case{43, 55, 24}, Case{43, 55, 37}, Case{100, 100, 24}, Case{100, 100, 37}),
                         [](const auto& info) {
                           return fmt::format("{}Vertices{}Bones", info.param.rows * info.param.columns,
                                              info.param.bones);
                         });

TEST(RigidBonesSpeed, AChainWithNothingKnown) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "SKIPPED: a matter of speed";
#endif
  const Chain chain(43, 55, 24);
  RigidBonesJob job{chain.rest, chain.posed, chain.triangles, poses};
  job.count = 24;
  const std::clock_t begin = std::clock();
  const auto found = job.run();
  ASSERT_TRUE(found) << found.error().message;
  const double seconds = 0.5 * processor_seconds_since(begin),
               error = chain.relative_rmse(found->influences, found->bones);
  fmt::print("{} vertices, 24 bones unknown: {:.2f} s, {} rounds, {:.3g}\n", chain.rest.size(), seconds, found->rounds,
             error);
  EXPECT_LE(error, 1.5e-3);
}

}  // namespace
}  // namespace sinew::test
