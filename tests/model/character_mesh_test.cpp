#include "engine/model/character_mesh.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/small_rig.h"

namespace sinew::test {
namespace {

/// A triangle whose vertices' x tells one from another.
Primitive triangle(double x) {
  Primitive out;
  for (int v = 0; v < 3; ++v) {
    out.positions.push_back({x + v, 0, 0});
    out.normals.push_back({0, 0, 1});
  }
  out.indices = {0, 2, 1};
  return out;
}

std::vector<double> xs(const CharacterMesh& mesh) {
  std::vector<double> all;
  for (const Vec3& p : mesh.positions) all.push_back(p.x);
  return all;
}

std::vector<Influence> run_of(const CharacterMesh& mesh, std::size_t v) {
  const auto begin = mesh.influences.entries.begin();
  return {begin + mesh.influences.first[v], begin + mesh.influences.first[v + 1]};
}

TEST(HierarchyOrder, ParentsComeFirstWhateverTheFilesOrder) {
  // The file lists children before parents, and siblings backwards.
  Model model;
  model.nodes.resize(5);
  const auto hang = [&](int child, int parent) {
    model.nodes[child].parent = parent;
    model.nodes[parent].children.push_back(child);
  };
  hang(3, 4);
  hang(0, 4);
  hang(2, 3);
  hang(1, 3);
  model.roots = {4};
  EXPECT_EQ(hierarchy_order(model), (std::vector<int>{4, 3, 2, 1, 0}));
}

TEST(HierarchyOrder, NodesOutsideTheSceneFollow) {
  Model model;
  model.nodes.resize(4);
  model.nodes[1].parent = 0;
  model.nodes[0].children = {1};
  model.nodes[2].parent = 3;
  model.nodes[3].children = {2};
  model.roots = {3};
  EXPECT_EQ(hierarchy_order(model), (std::vector<int>{3, 2, 0, 1}));
}

TEST(HierarchyOrder, HoldsEveryNodeOfADeepChainOnce) {
  Model model;
  for (int i = 0; i < 100'000; ++i) link(model, i - 1, {});
  const std::vector<int> order = hierarchy_order(model);
  ASSERT_EQ(order.size(), 100'000u);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

TEST(CharacterMesh, GoesDepthFirstThroughNodesAndTheirPrimitives) {
  Model model;
  model.meshes = {{"a", {triangle(10), triangle(20)}, {}}, {"b", {triangle(30)}, {}}, {"c", {triangle(40)}, {}}};
  const int first = link(model, -1, named("first"));
  const int second = link(model, -1, drawing("second", 0, -1));
  link(model, first, drawing("deep", 1, -1));
  link(model, first, drawing("deeper", 2, -1));
  model.roots = {first, second};
  const CharacterMesh mesh = character_mesh(model);
  EXPECT_EQ(xs(mesh), (std::vector<double>{30, 31, 32, 40, 41, 42, 10, 11, 12, 20, 21, 22}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::uint32_t>{0, 2, 1, 3, 5, 4, 6, 8, 7, 9, 11, 10}));
  ASSERT_EQ(mesh.parts.size(), 4u);
  EXPECT_EQ(mesh.parts[2].mesh, "a");
  EXPECT_EQ(mesh.parts[2].node, second);
  std::uint32_t vertex = 0, index = 0;
  for (const MeshPart& part : mesh.parts) {
    EXPECT_EQ(part.first_vertex, vertex);
    EXPECT_EQ(part.first_index, index);
    vertex += part.vertex_count;
    index += part.index_count;
  }
  EXPECT_EQ(vertex, mesh.vertices());
  EXPECT_EQ(index, mesh.triangles.size());
}

TEST(CharacterMesh, DrawsOnlyWhatTheSceneShows) {
  Model model;
  model.meshes = {{"a", {triangle(10)}, {}}};
  const int shown = link(model, -1, drawing("shown", 0, -1));
  link(model, -1, drawing("hidden", 0, -1));
  model.roots = {shown};
  EXPECT_EQ(xs(character_mesh(model)), (std::vector<double>{10, 11, 12}));
}

TEST(CharacterMesh, AMeshThatTwoNodesDrawStandsTwice) {
  Model model;
  model.meshes = {{"a", {triangle(10)}, {}}};
  link(model, -1, drawing("one", 0, -1));
  link(model, -1, drawing("other", 0, -1));
  const CharacterMesh mesh = character_mesh(model);
  ASSERT_EQ(mesh.vertices(), 6u);
  EXPECT_EQ(mesh.bone(2), 0);
  EXPECT_EQ(mesh.bone(3), 1);
  ASSERT_EQ(mesh.palette.size(), 2u);
  EXPECT_EQ(mesh.palette[1].inverse_bind, Mat4(1.0));
}

TEST(CharacterMesh, MeshesOfOneSkinShareItsPalette) {
  const Model model = two_meshes_on_one_skin();
  const CharacterMesh mesh = character_mesh(model);
  // Nine joints once, and the prop's node.
  ASSERT_EQ(mesh.palette.size(), joint_count + 1);
  for (const PaletteSource& source : mesh.palette) {
    const auto joint = std::find(model.skins[0].joints.begin(), model.skins[0].joints.end(), source.node);
    if (joint == model.skins[0].joints.end()) {
      EXPECT_EQ(source.node, prop_node);
      EXPECT_EQ(source.inverse_bind, Mat4(1.0));
    } else {
      EXPECT_EQ(source.inverse_bind,
                model.skins[0].inverse_bind[static_cast<std::size_t>(joint - model.skins[0].joints.begin())]);
    }
  }
}

TEST(CharacterMesh, InfluencesNameThePaletteAndSumToOne) {
  const Model model = two_meshes_on_one_skin();
  const CharacterMesh mesh = character_mesh(model);
  for (const MeshPart& part : mesh.parts) {
    const int skin = model.nodes[part.node].skin;
    for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
      const std::vector<Influence> run = run_of(mesh, v);
      ASSERT_FALSE(run.empty());
      double sum = 0.0;
      for (const Influence& i : run) sum += i.weight;
      EXPECT_NEAR(sum, 1.0, 1e-15 * max_influences);
      if (skin < 0) {
        EXPECT_EQ(mesh.bone(v), part.node);
      }
    }
  }
  // Vertex 9 of the body: the file's joints 0 and 1.
  const std::vector<Influence> run = run_of(mesh, 9), file = {{0, 2.0 / 3.0}, {1, 1.0 / 3.0}};
  ASSERT_EQ(run.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(mesh.palette[run[i].joint].node, first_joint + static_cast<int>((9 + i) % joint_count));
    EXPECT_DOUBLE_EQ(run[i].weight, file[i].weight);
  }
}

TEST(CharacterMesh, AVertexWithoutWeightsFollowsItsMeshsNode) {
  Model model = two_meshes_on_one_skin();
  Influences& influences = model.meshes[1].primitives[0].influences;
  const std::size_t vertices = influences.vertices();
  influences = {};
  influences.add_vertex({});
  for (std::size_t v = 1; v < vertices; ++v) influences.add_vertex({{2, 1.0}});
  const CharacterMesh mesh = character_mesh(model);
  const MeshPart& clothes =
      *std::find_if(mesh.parts.begin(), mesh.parts.end(), [](const MeshPart& part) { return part.mesh == "clothes"; });
  EXPECT_EQ(mesh.bone(clothes.first_vertex), clothes_node);
  EXPECT_EQ(mesh.palette[run_of(mesh, clothes.first_vertex)[0].joint].inverse_bind, Mat4(1.0));
  EXPECT_EQ(mesh.bone(clothes.first_vertex + 1), first_joint + 2);
}

TEST(CharacterMesh, WhatTheSceneDrawsIsCountedBeforeItIsGathered) {
  Model model;
  model.file = "many.glb";
  Primitive large;
  large.positions.resize(most_drawn_vertices / 4);
  model.meshes = {{"large", {large}, {}}};
  for (int i = 0; i < 4; ++i) link(model, -1, drawing("node", 0, -1));
  const int one_more = link(model, -1, drawing("node", 0, -1));
  const auto refused = check_drawn_vertices(model);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::bad_input);
  EXPECT_NE(refused.error().message.find("many.glb: its nodes draw 10000000 vertices"), std::string::npos)
      << refused.error().message;
  std::erase(model.roots, one_more);
  EXPECT_TRUE(check_drawn_vertices(model)) << "as many as there may be; what the scene does not show is not drawn";
}

TEST(CharacterMesh, TextureCoordinatesAreZeroWhereThereAreNone) {
  Model model;
  Primitive with = triangle(20);
  with.texture_coordinates = {{0.1, 0.2}, {0.3, 0.4}, {0.5, 0.6}};
  model.meshes = {{"a", {triangle(10), with, triangle(30)}, {}}};
  link(model, -1, drawing("node", 0, -1));
  const CharacterMesh mesh = character_mesh(model);
  ASSERT_EQ(mesh.texture_coordinates.size(), 9u);
  EXPECT_EQ(mesh.texture_coordinates[2], Vec2(0, 0));
  EXPECT_EQ(mesh.texture_coordinates[4], Vec2(0.3, 0.4));
  EXPECT_EQ(mesh.texture_coordinates[8], Vec2(0, 0));
}

TEST(CharacterMesh, MorphDeltasAreThoseOfTheTargetsWithoutTheZeros) {
  Model model;
  Primitive one = triangle(10), other = triangle(20);
  one.morph_targets = {{"up", {Vec3(0), Vec3(0, 1, 0), Vec3(0)}, {}},
                       {"turn", {}, {Vec3(0), Vec3(1, 0, 0), Vec3(2, 0, 0)}}};
  other.morph_targets = {{"up", {Vec3(0, 3, 0), Vec3(0), Vec3(0)}, {}}, {"turn", {}, {}}};
  model.meshes = {{"plain", {triangle(0)}, {}}, {"a", {one, other}, {}}};
  link(model, -1, drawing("plain", 0, -1));
  const int node = link(model, -1, drawing("node", 1, -1));
  link(model, -1, drawing("again", 1, -1));
  const CharacterMesh mesh = character_mesh(model);
  ASSERT_EQ(mesh.morph_slots.size(), 4u) << "two targets of each of two drawn meshes, not of each primitive";
  EXPECT_EQ(mesh.morph_slots[1].node, node);
  EXPECT_EQ(mesh.morph_slots[1].target, 1u);
  EXPECT_EQ(mesh.morph_slots[2].node, node + 1);
  const std::vector<std::uint32_t> first = {0, 0, 0, 0, 0, 2, 3, 4, 4, 4, 4, 6, 7, 8, 8, 8};
  EXPECT_EQ(mesh.morph_first, first);
  ASSERT_EQ(mesh.morph_deltas.size(), 8u);
  const auto expect = [&](std::size_t i, std::uint32_t slot, const Vec3& position, const Vec3& normal) {
    EXPECT_EQ(mesh.morph_deltas[i].slot, slot);
    EXPECT_EQ(mesh.morph_deltas[i].position, position);
    EXPECT_EQ(mesh.morph_deltas[i].normal, normal);
  };
  expect(0, 0, {0, 1, 0}, {0, 0, 0});
  expect(1, 1, {0, 0, 0}, {1, 0, 0});
  expect(2, 1, {0, 0, 0}, {2, 0, 0});
  expect(3, 0, {0, 3, 0}, {0, 0, 0});
  expect(7, 2, {0, 3, 0}, {0, 0, 0});
}

}  // namespace
}  // namespace sinew::test
