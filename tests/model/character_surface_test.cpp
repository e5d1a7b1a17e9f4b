/// What vertices carry for their material, gathered from several primitives.

#include <gtest/gtest.h>

#include "engine/model/character_mesh.h"
#include "engine/model/tangents.h"
#include "tests/support/small_rig.h"

namespace sinew::test {
namespace {

/// Three triangles in a row, the middle one with a material that has a normal texture.
Model three_triangles() {
  Model model;
  Primitive triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.normals.assign(3, Vec3(0, 0, 1));
  triangle.texture_coordinates = {{0, 1}, {0.5, 1}, {0.5, 0}};
  triangle.indices = {0, 1, 2};
  model.meshes = {{"three", {triangle, triangle, triangle}, {}}};
  model.materials.resize(2);
  model.materials[1].normal_texture.image = 0;
  model.images.resize(1);
  model.meshes[0].primitives[0].material = 0;
  model.meshes[0].primitives[1].material = 1;
  link(model, -1, drawing("node", 0, -1));
  return model;
}

TEST(CharacterSurface, WhatNoPrimitiveHasTakesNoRoom) {
  Model model = three_triangles();
  model.materials[1].normal_texture.image = -1;
  const CharacterMesh mesh = character_mesh(model);
  EXPECT_TRUE(mesh.tangents.empty());
  EXPECT_TRUE(mesh.second_texture_coordinates.empty());
  EXPECT_TRUE(mesh.colours.empty());
}

TEST(CharacterSurface, ColoursAreWhiteWhereAPrimitiveHasNone) {
  for (const std::size_t one : {0u, 1u, 2u}) {
    Model model = three_triangles();
    model.meshes[0].primitives[one].colours = {{1, 0, 0, 1}, {0, 1, 0, 0.5}, {0, 0, 1, 0}};
    const CharacterMesh mesh = character_mesh(model);
    ASSERT_EQ(mesh.colours.size(), 9u);
    for (std::size_t v = 0; v < 9; ++v)
      EXPECT_EQ(mesh.colours[v], v / 3 == one ? model.meshes[0].primitives[one].colours[v % 3] : Vec4(1.0)) << v;
  }
}

TEST(CharacterSurface, SecondCoordinatesAreZeroWhereAPrimitiveHasNone) {
  for (const std::size_t one : {0u, 1u, 2u}) {
    Model model = three_triangles();
    model.meshes[0].primitives[one].second_texture_coordinates = {{0.1, 0.2}, {0.3, 0.4}, {0.5, 0.6}};
    const CharacterMesh mesh = character_mesh(model);
    ASSERT_EQ(mesh.second_texture_coordinates.size(), 9u);
    for (std::size_t v = 0; v < 9; ++v)
      EXPECT_EQ(mesh.second_texture_coordinates[v],
                v / 3 == one ? model.meshes[0].primitives[one].second_texture_coordinates[v % 3] : Vec2(0.0))
          << v;
  }
}

TEST(CharacterSurface, TangentsAreTheFilesWhereItHasThem) {
  Model model = three_triangles();
  const std::vector<Vec4> own = {{0, 1, 0, -1}, {0, -1, 0, 1}, {1, 0, 0, -1}};
  model.meshes[0].primitives[1].tangents = own;
  const CharacterMesh mesh = character_mesh(model);
  ASSERT_EQ(mesh.tangents.size(), 9u);
  for (std::size_t v = 0; v < 9; ++v) EXPECT_EQ(mesh.tangents[v], v / 3 == 1 ? own[v % 3] : Vec4(1, 0, 0, 1)) << v;
}

TEST(CharacterSurface, TangentsAreGeneratedForTheNormalTextureAsItLies) {
  Model model = three_triangles();
  Texture& texture = model.materials[1].normal_texture;
  texture.rotation = 0.7;
  texture.coordinates = 1;
  Primitive& middle = model.meshes[0].primitives[1];
  middle.second_texture_coordinates = {{0, 0}, {0, 1}, {1, 0}};
  const std::vector<Vec4> expected = generate_tangents(middle, texture);
  EXPECT_NE(expected[0], Vec4(1, 0, 0, 1));
  const CharacterMesh mesh = character_mesh(model);
  ASSERT_EQ(mesh.tangents.size(), 9u);
  for (std::size_t v = 3; v < 6; ++v) EXPECT_EQ(mesh.tangents[v], expected[v - 3]);
}

TEST(CharacterSurface, AllOfADressedCharacterIsThere) {
  const Model model = dressed_meshes();
  const CharacterMesh mesh = character_mesh(model);
  ASSERT_EQ(mesh.tangents.size(), mesh.vertices());
  ASSERT_EQ(mesh.colours.size(), mesh.vertices());
  ASSERT_EQ(mesh.second_texture_coordinates.size(), mesh.vertices());
  for (const MeshPart& part : mesh.parts) {
    if (part.mesh != "clothes") continue;
    const Primitive& from = model.meshes[dressed_mesh].primitives[0];
    for (std::uint32_t v = 0; v < part.vertex_count; ++v) {
      EXPECT_EQ(mesh.tangents[part.first_vertex + v], from.tangents[v]);
      EXPECT_EQ(mesh.colours[part.first_vertex + v], from.colours[v]);
      EXPECT_EQ(mesh.second_texture_coordinates[part.first_vertex + v], from.second_texture_coordinates[v]);
    }
  }
}

}  // namespace
}  // namespace sinew::test
