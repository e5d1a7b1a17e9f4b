#include "engine/deform/rigid.h"

#include <gtest/gtest.h>

#include "engine/deform/ssd.h"
#include "tests/deform/dense_skin.h"
#include "tests/support/test_character.h"
#include "tests/support/tube.h"

namespace sinew::test {
namespace {

/// Roundings of a dozen sums and products of numbers of size one.
constexpr double rounding = 1e-13;

constexpr Deforming rigidly{.bulge = BulgeMode::off, .deformer = Deformer::rigid};

TEST(Rigid, EveryVertexFollowsTheJointOfItsLargestWeight) {
  const TestCharacter limb(tube());
  const Pose pose = limb.turned(tube_lower, {70, 10, 0});
  const std::vector<Mat34> palette = limb.palette(pose);
  const Eigen::MatrixXd weights = dense_weights(limb.mesh.influences, palette.size());
  const DeformedVertices out = deformed(limb, pose, rigidly);
  for (std::size_t v = 0; v < limb.mesh.vertices(); ++v) {
    Eigen::Index strongest = 0;
    weights.row(static_cast<Eigen::Index>(v)).maxCoeff(&strongest);  // of equal ones the first
    const Eigen::Matrix4d bone = eigen(palette[static_cast<std::size_t>(strongest)]);
    EXPECT_LT(glm::length(out.positions[v] - dense_point(bone, limb.mesh.positions[v])), rounding);
    EXPECT_LT(glm::length(out.normals[v] - dense_normal(bone, limb.mesh.normals[v])), rounding);
    EXPECT_LT((eigen(out.blend[v]) - bone.topLeftCorner<3, 3>()).norm(), rounding);
  }
}

TEST(Rigid, OfEqualWeightsTheFirstJointOfTheSkinLeads) {
  const TestCharacter limb(tube());
  const Pose pose = limb.turned(tube_lower, {90, 0, 0});
  const DeformedVertices out = deformed(limb, pose, rigidly);
  std::size_t ties = 0;
  for (std::size_t v = 0; v < limb.mesh.vertices(); ++v) {
    if (limb.mesh.positions[v].y != 1.0) continue;  // twist and lower hold half of it each; the twist stands first
    EXPECT_LT(glm::length(out.positions[v] - limb.mesh.positions[v]), rounding);
    ++ties;
  }
  EXPECT_EQ(ties, 24u);
}

TEST(Rigid, OneBoneIsTheSameAsBlending) {
  Model model = tube();
  Primitive& skin = model.meshes[0].primitives[0];
  skin.influences = {};
  for (std::size_t v = 0; v < skin.positions.size(); ++v) skin.influences.add_vertex({{tube_lower, 1.0}});
  const TestCharacter limb(model);
  const Pose pose = limb.turned(tube_lower, {70, 40, -20});
  const DeformedVertices rigid = deformed(limb, pose, rigidly);
  const DeformedVertices blended = deformed(limb, pose, {.bulge = BulgeMode::off});
  EXPECT_EQ(largest_distance(rigid.positions, blended.positions), 0.0);
  EXPECT_EQ(largest_distance(rigid.normals, blended.normals), 0.0);
}

TEST(Rigid, ScaleTurnsNormalsByTheInverseTranspose) {
  Model model = tube();
  model.nodes[tube_upper].rest.scale = {0.5, 1.0, 3.0};
  const TestCharacter limb(model);
  const Pose pose = limb.turned(tube_upper, {10, 20, 30});
  const DeformedVertices out = deformed(limb, pose, rigidly);
  for (std::size_t v = 0; v < limb.mesh.vertices(); ++v) {
    const Eigen::Matrix4d bone =
        eigen(limb.palette(pose)[limb.mesh.influences.entries[limb.mesh.influences.first[v]].joint]);
    EXPECT_LT(glm::length(out.normals[v] - dense_normal(bone, limb.mesh.normals[v])), rounding);
  }
}

TEST(Rigid, SegmentsComeApartAtTheJoint) {
  const TestCharacter limb(tube());
  const Pose pose = limb.turned(tube_lower, {90, 0, 0});
  const auto longest_edge = [&](const std::vector<Vec3>& positions) {
    double longest = 0.0;
    for (std::size_t i = 0; i + 1 < limb.mesh.triangles.size(); i += 3)
      longest =
          std::max(longest, glm::distance(positions[limb.mesh.triangles[i]], positions[limb.mesh.triangles[i + 2]]));
    return longest;
  };
  const double bind = longest_edge(limb.mesh.positions);
  EXPECT_GT(longest_edge(deformed(limb, pose, rigidly).positions), 3.0 * bind);
  EXPECT_LT(longest_edge(deformed(limb, pose, {.bulge = BulgeMode::off}).positions), 2.0 * bind);
}

TEST(Rigid, ItsSpansAreCheckedAsAllSkinsAre) {
  std::vector<Vec3> three(3), two(2);
  std::vector<Mat34> palette(1);
  Influences influences;
  for (int v = 0; v < 3; ++v) influences.add_vertex({{0, 1.0}});
  EXPECT_TRUE((RigidJob{{three, three, palette, influences}, {three, three, {}}}.validate()));
  EXPECT_FALSE((RigidJob{{three, two, palette, influences}, {three, three, {}}}.validate()));
  EXPECT_FALSE((RigidJob{{three, three, palette, influences}, {two, three, {}}}.validate()));
  EXPECT_FALSE((RigidJob{{three, three, {}, influences}, {three, three, {}}}.validate()));
}

}  // namespace
}  // namespace sinew::test
