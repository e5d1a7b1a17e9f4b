/// Skin weights from example poses: what is known is found again, what is not there is said.

#include "engine/fit/skin_fit.h"

#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include "engine/fit/random_poses.h"
#include "engine/fit/skinned_shape.h"
#include "engine/fit/surface_graph.h"
#include "engine/fit/vertex_fit.h"
#include "tests/support/tube.h"

namespace sinew::test {
namespace {

/// A tube in random poses, its weights known.
struct Example {
  explicit Example(std::size_t poses, const Model& m = tube(), std::uint64_t seed = 3) : model(m), random(seed) {
    shape = skinned_shapes(model).front();
    bones = BonePoses(bone_poses(model, 0, random_poses(model, model.skins[0].joints, poses, random)));
    posed = skinned_places(shape.positions, shape.influences, bones);
  }

  void add_noise(double sigma) {
    for (Vec3& place : posed)
      for (int i = 0; i < 3; ++i) place[i] += sigma * random.normal();
  }
  SkinFitJob job(FitMethod method = FitMethod::convex) const {
    return {shape.positions, posed, shape.triangles, bones, method};
  }
  Influences fit(FitMethod method = FitMethod::convex) {
    const auto influences = job(method).run(report);
    EXPECT_TRUE(influences) << influences.error().message;
    return *influences;
  }
  /// 3-D root mean square over vertices and poses.
  double rmse(const Influences& influences, const BonePoses& in) const {
    const std::vector<Vec3> wanted = skinned_places(shape.positions, shape.influences, in);
    const std::vector<Vec3> found = skinned_places(shape.positions, influences, in);
    double squared = 0.0;
    for (std::size_t i = 0; i < wanted.size(); ++i) squared += glm::dot(wanted[i] - found[i], wanted[i] - found[i]);
    return std::sqrt(squared / static_cast<double>(wanted.size()));
  }
  BonePoses unseen() { return bone_poses(model, 0, random_poses(model, model.skins[0].joints, 20, random)); }

  Model model;
  RandomNumbers random;
  SkinnedShape shape;
  BonePoses bones;
  std::vector<Vec3> posed;
  SkinFitReport report;
};

double weight_of(const Influences& influences, std::size_t v, std::uint32_t joint) {
  for (std::uint32_t i = influences.first[v]; i < influences.first[v + 1]; ++i)
    if (influences.entries[i].joint == joint) return influences.entries[i].weight;
  return 0.0;
}

void expect_valid(const Influences& influences, std::size_t most) {
  for (std::size_t v = 0; v < influences.vertices(); ++v) {
    double sum = 0.0;
    for (std::uint32_t i = influences.first[v]; i < influences.first[v + 1]; ++i) {
      const Influence& influence = influences.entries[i];
      EXPECT_GT(influence.weight, 0.0);
      if (i > influences.first[v]) {
        EXPECT_LE(influence.weight, influences.entries[i - 1].weight);
      }
      sum += influence.weight;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_LE(influences.first[v + 1] - influences.first[v], most);
  }
}

TEST(SkinFit, FindsTheWeightsThatMadeTheExamples) {
  Example example(20);
  const Influences fitted = example.fit();
  expect_valid(fitted, 4);
  // Weights come from squared lengths, of which a double holds 16 digits: 8 of the weights at best.
  for (std::size_t v = 0; v < fitted.vertices(); ++v)
    for (std::uint32_t joint = 0; joint < 5; ++joint)
      EXPECT_NEAR(weight_of(fitted, v, joint), weight_of(example.shape.influences, v, joint), 1e-5) << v;
  EXPECT_LT(example.rmse(fitted, example.unseen()), 1e-6);
  EXPECT_LT(example.report.noise, 1e-7);
  EXPECT_EQ(example.report.shells, 1u);
}

TEST(SkinFit, ThePapersMethodFindsThemWhereLoneErrorsChooseWell) {
  Example example(20);
  const Influences fitted = example.fit(FitMethod::paper);
  expect_valid(fitted, 4);
  EXPECT_LT(example.rmse(fitted, example.bones), 1e-6);
}

/// A vertex half way between two bones that part widely, and four bones that stay near the middle: each of them alone
/// fits better than either of the two, none of them nor all together as well as the two.
TEST(SkinFit, LoneErrorsChooseWronglyWhereTwoBonesTogetherFit) {
  BonePoses bones(6, 8);
  RandomNumbers random(5);
  const Vec3 rest(0.0, 1.0, 0.0);
  std::vector<Vec3> posed;
  for (std::size_t k = 0; k < bones.poses; ++k) {
    const Vec3 apart(random.normal(), random.normal(), random.normal());
    const Vec3 drift(random.normal(), random.normal(), random.normal());
    const auto move = [&](std::size_t b, const Vec3& by) {
      for (int i = 0; i < 3; ++i) bones.at(b, k).row[i].w = by[i];
    };
    move(0, drift + apart);
    move(1, drift - apart);
    for (std::size_t b = 2; b < 6; ++b) {
      const Vec3 near(random.normal(), random.normal(), random.normal());
      move(b, drift + 0.2 * near);
    }
    posed.push_back(rest + drift);
  }
  VertexFit fit(bones);
  fit.begin(rest, posed);
  const Support papers = fit.paper(2), ours = fit.convex(2);
  EXPECT_FALSE(papers.has(0) || papers.has(1));
  EXPECT_GT(papers.error, 0.1);
  EXPECT_TRUE(ours.has(0) && ours.has(1));
  EXPECT_LT(ours.error, 1e-20);
}

TEST(SkinFit, NoiseIsSmoothedAway) {
  Example example(20);
  const double sigma = 0.002;
  example.add_noise(sigma);
  const Influences fitted = example.fit();
  expect_valid(fitted, 4);
  EXPECT_NEAR(example.report.noise, sigma, 0.1 * sigma);
  const BonePoses unseen = example.unseen();
  const double ours = example.rmse(fitted, unseen);
  // Three free weights out of 60 numbers would leave sigma * sqrt(3 / 20) without any smoothing.
  EXPECT_LT(ours, 0.39 * sigma);
  EXPECT_LT(ours, 0.7 * example.rmse(example.fit(FitMethod::paper), unseen));
}

TEST(SkinFit, SmoothingKeepsARealEdge) {
  // Every vertex follows one bone whole, and at the elbow the next row follows the other.
  Model model = tube();
  Primitive& skin = model.meshes[0].primitives[0];
  skin.influences = {};
  for (const Vec3& p : skin.positions)
    skin.influences.add_vertex({{static_cast<std::uint32_t>(p.y < 1.0 ? tube_upper : tube_lower), 1.0}});
  Example example(20, model);
  example.add_noise(0.002);
  const Influences fitted = example.fit();
  // A tenth of the elbow's rows swing by about 0.1: 0.02 of weight is what the noise allows a vertex there.
  for (std::size_t v = 0; v < fitted.vertices(); ++v) {
    const bool upper = example.shape.positions[v].y < 1.0;
    if (std::abs(example.shape.positions[v].y - 1.0) < 0.05) continue;
    EXPECT_GT(weight_of(fitted, v, upper ? tube_upper : tube_lower) + (upper ? weight_of(fitted, v, tube_root) : 0.0) +
                  (upper ? weight_of(fitted, v, tube_twist) : weight_of(fitted, v, tube_hand)),
              0.97)
        << v;
  }
}

TEST(SkinFit, TheNumberOfThreadsChangesNothing) {
  Example example(10);
  example.add_noise(0.001);
  const Influences many = example.fit();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Influences single = example.fit();
  EXPECT_EQ(many.first, single.first);
  ASSERT_EQ(many.entries.size(), single.entries.size());
  for (std::size_t i = 0; i < many.entries.size(); ++i) {
    EXPECT_EQ(many.entries[i].joint, single.entries[i].joint);
    EXPECT_EQ(many.entries[i].weight, single.entries[i].weight);
  }
}

TEST(SkinFit, SaysWhatIsWrong) {
  Example example(2);
  const auto message = [](const SkinFitJob& job) {
    const auto ok = job.validate();
    return ok ? std::string() : ok.error().message;
  };
  EXPECT_EQ(message(example.job()), "");
  SkinFitJob crowded = example.job();
  crowded.influences = 9;
  EXPECT_NE(message(crowded).find("9 influences"), std::string::npos);
  SkinFitJob short_of = example.job();
  short_of.posed = short_of.posed.first(7);
  EXPECT_NE(message(short_of).find("7 posed vertices"), std::string::npos);
  example.posed[5].y = NAN;
  EXPECT_NE(message(example.job()).find("pose 1, vertex 2"), std::string::npos);
  const BonePoses none;
  EXPECT_NE(message({example.shape.positions, {}, {}, none}).find("no bone"), std::string::npos);
  const Example single(1);
  SkinFitJob too_few = single.job();
  too_few.influences = 5;
  EXPECT_NE(message(too_few).find("too few"), std::string::npos);
}

TEST(SkinFit, BonesThatMoveAlikeAreNamed) {
  Example example(4);
  Bounds bounds;
  for (const Vec3& p : example.shape.positions) bounds.add(p);
  EXPECT_TRUE(bones_moved_alike(example.bones, bounds).empty());
  for (std::size_t k = 0; k < 4; ++k) example.bones.at(tube_hand, k) = example.bones.at(tube_lower, k);
  const auto alike = bones_moved_alike(example.bones, bounds);
  ASSERT_EQ(alike.size(), 1u);
  EXPECT_EQ(alike[0], (std::pair<std::uint32_t, std::uint32_t>(tube_hand, tube_lower)));
}

TEST(SurfaceGraph, SeamsAreClosedAndShellsCounted) {
  // Two triangles that meet at doubled corners, and one far away.
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0},
                                    {1, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  const std::vector<std::uint32_t> triangles{0, 1, 2, 3, 5, 4, 6, 7, 8};
  const SurfaceGraph graph = surface_graph(positions, triangles);
  EXPECT_EQ(graph.shells, 2u);
  EXPECT_EQ(graph.shell[0], graph.shell[5]);
  EXPECT_NE(graph.shell[0], graph.shell[6]);
  const auto beside = graph.of(1);
  EXPECT_EQ(std::vector(beside.begin(), beside.end()), (std::vector<std::uint32_t>{0, 2, 3}));
}

}  // namespace
}  // namespace sinew::test
