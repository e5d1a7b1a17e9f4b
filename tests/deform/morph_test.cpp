#include "engine/deform/morph.h"

#include <gtest/gtest.h>

#include "tests/support/test_character.h"
#include "tests/support/tube.h"

namespace sinew::test {
namespace {

/// Roundings of a few sums and products of numbers of size one.
constexpr double rounding = 1e-15;

/// A tube with a target that moves everything, one that only turns the normals of a few, and one without any change.
Model morphing_tube() {
  Model model = tube();
  Primitive& skin = model.meshes[0].primitives[0];
  const std::size_t vertices = skin.positions.size();
  Random random(4);
  skin.morph_targets = {{"all", {}, {}}, {"few", {}, std::vector<Vec3>(vertices)}, {"none", {}, {}}};
  for (std::size_t v = 0; v < vertices; ++v) skin.morph_targets[0].positions.push_back(random.vector(0.1));
  for (const std::size_t v : {0u, 5u, 17u}) skin.morph_targets[1].normals[v] = random.vector();
  model.meshes[0].morph_weights = {0, 0, 0};
  return model;
}

TEST(Morph, AddsEachTargetByItsWeight) {
  const Model model = morphing_tube();
  const CharacterMesh mesh = character_mesh(model);
  const std::vector<MorphTarget>& targets = model.meshes[0].primitives[0].morph_targets;
  // glTF allows any weight, below 0 and above 1 as well.
  for (const std::vector<double>& weights : {std::vector<double>{1, 0, 0}, {0.25, -0.5, 3}, {2, 1, 0}, {0, 0, 1}}) {
    const MorphedVertices out = morph(mesh, weights);
    ASSERT_EQ(out.positions.size(), mesh.vertices());
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
      EXPECT_LT(glm::length(out.positions[v] - mesh.positions[v] - weights[0] * targets[0].positions[v]), rounding);
      EXPECT_LT(glm::length(out.normals[v] - mesh.normals[v] - weights[1] * targets[1].normals[v]), rounding);
    }
  }
}

TEST(Morph, WeightsOfZeroAndMeshesWithoutTargetsChangeNoBit) {
  const CharacterMesh mesh = character_mesh(morphing_tube()), plain = character_mesh(tube());
  const std::vector<double> zeros(3);
  EXPECT_EQ(morph(mesh, zeros).positions, mesh.positions);
  EXPECT_EQ(morph(mesh, zeros).normals, mesh.normals);
  EXPECT_EQ(morph(plain, {}).positions, plain.positions);
}

TEST(Morph, EachDrawnMeshFollowsItsOwnWeights) {
  Model model = morphing_tube();
  add_node(model, "again", -1, {});
  model.nodes.back().mesh = model.nodes.back().skin = 0;
  const CharacterMesh mesh = character_mesh(model);
  const std::size_t half = mesh.vertices() / 2;
  const std::vector<MorphTarget>& targets = model.meshes[0].primitives[0].morph_targets;
  const MorphedVertices out = morph(mesh, std::vector<double>{1, 0, 0, -1, 0, 0});
  for (std::size_t v = 0; v < half; ++v) {
    EXPECT_LT(glm::length(out.positions[v] - mesh.positions[v] - targets[0].positions[v]), rounding);
    EXPECT_LT(glm::length(out.positions[half + v] - mesh.positions[v] + targets[0].positions[v]), rounding);
  }
}

}  // namespace
}  // namespace sinew::test
