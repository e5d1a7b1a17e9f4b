#include "engine/deform/reference.h"

#include <gtest/gtest.h>

#include "tests/deform/dense_skin.h"
#include "tests/deform/swelling_tube.h"

namespace sinew::test {
namespace {

/// Roundings of a dozen sums and products of numbers of size one.
constexpr double rounding = 1e-13;

Model morphing_tube() { return swelling_tube(0.5, {.rest_bend = 25}); }

Muscle upper_muscle() {
  Muscle muscle;
  muscle.bone = tube_upper;
  muscle.child = muscle.driver = tube_lower;
  muscle.facing = {0, 0, 1};
  muscle.peak = 0.05;
  muscle.sigma = {0.2, 0.15};
  return muscle;
}

TEST(RestShape, IsTheFilesRestPoseWithItsMorphs) {
  const TestCharacter limb(morphing_tube());
  const std::vector<Mat34> palette = limb.palette(rest_pose(limb.model));
  const Eigen::MatrixXd weights = dense_weights(limb.mesh.influences, palette.size());
  const MorphTarget& target = limb.model.meshes[0].primitives[0].morph_targets[0];
  for (std::size_t v = 0; v < limb.mesh.vertices(); ++v) {
    const Eigen::Matrix4d blend = dense_blend(weights, palette, v);
    const Vec3 position = limb.mesh.positions[v] + 0.5 * target.positions[v];
    const Vec3 normal = limb.mesh.normals[v] + 0.5 * target.normals[v];
    EXPECT_LT(glm::length(limb.rest.positions[v] - dense_point(blend, position)), rounding);
    EXPECT_LT(glm::length(limb.rest.normals[v] - dense_normal(blend, normal)), rounding);
    EXPECT_LT((eigen(limb.rest.blend[v]) - blend.topLeftCorner<3, 3>()).norm(), rounding);
  }
  ASSERT_EQ(limb.rest.global.size(), limb.model.nodes.size());
  EXPECT_LT(glm::length(Vec3(limb.rest.global[tube_lower][3]) - Vec3(0, 1, 0)), rounding);
}

TEST(Reference, MorphsThenSkins) {
  const TestCharacter limb(morphing_tube());
  Pose pose = limb.turned(tube_lower, {60, 10, 0});
  pose.morph_weights[tube_skin] = {1.5};
  const DeformedVertices out = deformed(limb, pose);
  const std::vector<Mat34> palette = limb.palette(pose);
  const Eigen::MatrixXd weights = dense_weights(limb.mesh.influences, palette.size());
  const MorphTarget& target = limb.model.meshes[0].primitives[0].morph_targets[0];
  for (std::size_t v = 0; v < limb.mesh.vertices(); ++v) {
    const Eigen::Matrix4d blend = dense_blend(weights, palette, v);
    EXPECT_LT(glm::length(out.positions[v] - dense_point(blend, limb.mesh.positions[v] + 1.5 * target.positions[v])),
              rounding);
    EXPECT_LT(glm::length(out.normals[v] - dense_normal(blend, limb.mesh.normals[v] + 1.5 * target.normals[v])),
              rounding);
    EXPECT_LT((eigen(out.blend[v]) - blend.topLeftCorner<3, 3>()).norm(), rounding);
    EXPECT_EQ(out.heights[v], 0.0);
  }
}

TEST(Reference, BulgesLast) {
  const TestCharacter limb(morphing_tube());
  const Muscle muscle = upper_muscle();
  const MuscleRegion region = limb.region(muscle);
  const ActiveMuscle active[] = {{muscle, region, 1.0}};
  Pose pose = limb.turned(tube_lower, {60, 10, 0});
  pose.morph_weights[tube_skin] = {-1.0};
  for (const Deformer deformer : {Deformer::ssd, Deformer::rigid}) {
    const DeformedVertices skin = deformed(limb, pose, {.bulge = BulgeMode::off, .deformer = deformer});
    const DeformedVertices out = deformed(limb, pose, {.muscles = active, .deformer = deformer});
    double largest = 0.0;
    for (std::size_t v = 0; v < limb.mesh.vertices(); ++v) {
      largest = std::max(largest, out.heights[v]);
      EXPECT_LT(glm::length(out.positions[v] - skin.positions[v] - out.heights[v] * skin.normals[v]), rounding);
      EXPECT_EQ(out.blend[v], skin.blend[v]);
    }
    EXPECT_GT(largest, 0.04);
  }
}

TEST(Reference, TheSwollenNormalIsThatOfTheMorphedSkin) {
  // The tangents span the plane of the morphed normal: where nothing slopes, the normal is the skin's.
  const TestCharacter limb(morphing_tube());
  Muscle muscle = upper_muscle();
  muscle.sigma = {1e6, 1e6};
  muscle.spread = 180;
  const MuscleRegion region = limb.region(muscle);
  const ActiveMuscle active[] = {{muscle, region, 1.0}};
  Pose pose = limb.turned(tube_lower, {60, 10, 0});
  pose.morph_weights[tube_skin] = {2.0};
  const DeformedVertices skin = deformed(limb, pose, {.bulge = BulgeMode::off});
  const DeformedVertices out = deformed(limb, pose, {.muscles = active, .bulge = BulgeMode::paper});
  // A Gaussian as wide as this slopes by peak x distance / sigma^2 = 5e-14.
  EXPECT_LT(largest_distance(out.normals, skin.normals), 1e-12);
  EXPECT_GT(largest_distance(out.positions, skin.positions), 0.04);
}

TEST(Reference, DoesNotDependOnTheNumberOfThreads) {
  const TestCharacter limb(tube({.rows = 257, .columns = 96}));
  const Pose pose = limb.turned(tube_lower, {60, 10, 0});
  const DeformedVertices first = deformed(limb, pose);
  for (int i = 0; i < 5; ++i) {
    const DeformedVertices again = deformed(limb, pose);
    EXPECT_EQ(again.positions, first.positions);
    EXPECT_EQ(again.normals, first.normals);
  }
}

TEST(NearlySingular, AsksWhetherTheSmallestSingularValueIsUnderATwentiethOfTheLargest) {
  Random random(9);
  for (const auto& [smallest, expected] : {std::pair(0.0501, false), {0.0499, true}, {0.0, true}, {1.0, false}})
    for (const double middle : {0.06, 0.5, 1.0})
      for (const double scale : {1e-3, 1.0, 1e3}) {
        const Mat3 before = glm::mat3_cast(random.rotation()), after = glm::mat3_cast(random.rotation());
        const Mat3 blend =
            after * Mat3(Vec3(scale, 0, 0), Vec3(0, scale * middle, 0), Vec3(0, 0, -scale * smallest)) * before;
        EXPECT_EQ(nearly_singular(blend), expected || middle < 0.05) << smallest << " " << middle << " " << scale;
      }
}

TEST(NearlySingular, AgreesWithASingularValueDecomposition) {
  Random random(10);
  int singular = 0;
  for (int i = 0; i < 2000; ++i) {
    const Mat3 blend(random.vector(), random.vector(), random.vector());
    const Eigen::Vector3d values = Eigen::JacobiSVD<Eigen::Matrix3d>(eigen(blend)).singularValues();
    EXPECT_EQ(nearly_singular(blend), values(2) < 0.05 * values(0));
    singular += nearly_singular(blend);
  }
  EXPECT_GT(singular, 50);
  EXPECT_LT(singular, 1950);
}

}  // namespace
}  // namespace sinew::test
