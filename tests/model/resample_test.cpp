#include "engine/model/resample.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "tests/support/tube.h"

namespace sinew::test {
namespace {

/// How the morph target of morphing_tubes() moves a place: linear, so that the mean of two ends is right in the middle.
Vec3 morphed_by(const Vec3& p) { return {0.5 * p.y, p.x - p.z, 0.25 * p.x}; }

Vec4 colour_at(const Vec3& p) { return {0.5 + p.x, 0.25 * p.y, 0.5 + p.z, 1.0 - 0.25 * p.y}; }
Vec2 second_coordinates_at(const Vec3& p) { return {0.5 * p.y, p.x - p.z}; }

/// Two tubes side by side, the second without a morph target.
CharacterMesh tubes() {
  Model model = tube({.rows = 9, .columns = 12});
  Primitive& skin = model.meshes[0].primitives[0];
  skin.morph_targets = {{"sway", {}, std::vector<Vec3>(skin.positions.size(), Vec3(0.25, 0, 0))}};
  for (const Vec3& p : skin.positions) skin.morph_targets[0].positions.push_back(morphed_by(p));
  for (const Vec3& p : skin.positions) skin.texture_coordinates.push_back({p.x + p.z, p.y});
  model.meshes.push_back({"other", {tube_surface({.radius = 0.1, .rows = 5, .columns = 6})}, {}});
  add_node(model, "other", -1, {});
  model.nodes.back().mesh = 1;
  model.nodes.back().skin = 0;
  return character_mesh(model);
}

std::size_t edges_of(const CharacterMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    ++edges[std::minmax(mesh.triangles[i], mesh.triangles[i - i % 3 + (i + 1) % 3])];
  return edges.size();
}

double area_of(const CharacterMesh& mesh) {
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const Vec3& a = mesh.positions[mesh.triangles[i]];
    area += 0.5 * glm::length(
                      glm::cross(mesh.positions[mesh.triangles[i + 1]] - a, mesh.positions[mesh.triangles[i + 2]] - a));
  }
  return area;
}

/// What every mesh must hold to.
void expect_sound(const CharacterMesh& mesh) {
  const std::size_t vertices = mesh.vertices();
  EXPECT_EQ(mesh.normals.size(), vertices);
  EXPECT_EQ(mesh.texture_coordinates.size(), vertices);
  for (const std::size_t size : {mesh.second_texture_coordinates.size(), mesh.colours.size(), mesh.tangents.size()})
    EXPECT_TRUE(size == 0 || size == vertices) << size;
  EXPECT_EQ(mesh.influences.vertices(), vertices);
  EXPECT_EQ(mesh.morph_first.size(), vertices + 1);
  EXPECT_EQ(mesh.morph_first.back(), mesh.morph_deltas.size());
  std::uint32_t first_vertex = 0, first_index = 0;
  for (const MeshPart& part : mesh.parts) {
    EXPECT_EQ(part.first_vertex, first_vertex);
    EXPECT_EQ(part.first_index, first_index);
    for (std::uint32_t i = 0; i < part.index_count; ++i) {
      EXPECT_GE(mesh.triangles[first_index + i], first_vertex);
      EXPECT_LT(mesh.triangles[first_index + i], first_vertex + part.vertex_count);
    }
    first_vertex += part.vertex_count;
    first_index += part.index_count;
  }
  EXPECT_EQ(first_vertex, vertices);
  EXPECT_EQ(first_index, mesh.triangles.size());
  for (std::size_t v = 0; v < vertices; ++v) {
    EXPECT_NEAR(glm::length(mesh.normals[v]), 1.0, 1e-12);
    double sum = 0.0;
    std::map<std::uint32_t, int> joints;
    for (std::uint32_t i = mesh.influences.first[v]; i < mesh.influences.first[v + 1]; ++i) {
      const Influence& now = mesh.influences.entries[i];
      EXPECT_LT(now.joint, mesh.palette.size());
      EXPECT_EQ(++joints[now.joint], 1);
      EXPECT_GT(now.weight, 0.0);
      sum += now.weight;
      if (i == mesh.influences.first[v]) continue;
      const Influence& before = mesh.influences.entries[i - 1];
      EXPECT_TRUE(now.weight < before.weight || (now.weight == before.weight && now.joint > before.joint));
    }
    EXPECT_LE(joints.size(), max_influences);
    EXPECT_NEAR(sum, 1.0, 1e-14);
  }
}

TEST(Resample, OneSplitAddsAVertexAnEdgeAndQuartersTheTriangles) {
  const CharacterMesh coarse = tubes();
  const std::size_t wanted = coarse.vertices() + edges_of(coarse);
  const CharacterMesh fine = resample(coarse, wanted).value();
  EXPECT_EQ(fine.vertices(), wanted);
  EXPECT_EQ(fine.triangles.size(), 4 * coarse.triangles.size());
  EXPECT_NEAR(area_of(fine), area_of(coarse), 1e-12);
  expect_sound(fine);
}

TEST(Resample, DataAtAMidpointIsTheMeanOfBothEnds) {
  const CharacterMesh coarse = tubes();
  const CharacterMesh fine = resample(coarse, coarse.vertices() + edges_of(coarse)).value();
  const std::uint32_t kept = coarse.parts[0].vertex_count;
  for (std::uint32_t v = 0; v < kept; ++v) EXPECT_EQ(fine.positions[v], coarse.positions[v]);
  for (std::uint32_t v = 0; v < fine.parts[0].vertex_count; ++v) {
    const Vec3& p = fine.positions[v];
    EXPECT_LT(glm::length(fine.texture_coordinates[v] - Vec2(p.x + p.z, p.y)), 1e-15);
    ASSERT_EQ(fine.morph_first[v + 1] - fine.morph_first[v], 1u);
    const MorphDelta& delta = fine.morph_deltas[fine.morph_first[v]];
    EXPECT_LT(glm::length(delta.position - morphed_by(p)), 1e-15);
    EXPECT_EQ(delta.normal, Vec3(0.25, 0, 0));
  }
  EXPECT_EQ(fine.morph_first[fine.parts[1].first_vertex], fine.morph_deltas.size()) << "the second has no target";
}

CharacterMesh one_triangle() {
  CharacterMesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  mesh.normals.assign(3, Vec3(0, 0, 1));
  mesh.texture_coordinates.assign(3, Vec2(0));
  mesh.triangles = {0, 1, 2};
  mesh.morph_first.assign(4, 0);
  mesh.palette.resize(4);
  mesh.parts = {{"", 0, -1, 0, 3, 0, 3}};
  mesh.influences.add_vertex({{0, 0.75}, {1, 0.25}});
  mesh.influences.add_vertex({{1, 1.0}});
  mesh.influences.add_vertex({{3, 0.5}, {2, 0.25}, {0, 0.25}});
  return mesh;
}

TEST(Resample, WeightsAtAMidpointAreTheMeanOfBothEnds) {
  const CharacterMesh mesh = one_triangle();
  const CharacterMesh fine = resample(mesh, 6).value();
  ASSERT_EQ(fine.vertices(), 6u);
  const auto run_at = [&](const Vec3& place) {
    std::vector<std::pair<std::uint32_t, double>> run;
    for (std::size_t v = 0; v < 6; ++v)
      if (fine.positions[v] == place)
        for (std::uint32_t i = fine.influences.first[v]; i < fine.influences.first[v + 1]; ++i)
          run.emplace_back(fine.influences.entries[i].joint, fine.influences.entries[i].weight);
    return run;
  };
  using Run = std::vector<std::pair<std::uint32_t, double>>;
  EXPECT_EQ(run_at({1, 0, 0}), (Run{{1, 0.625}, {0, 0.375}}));
  // Four joints, but no more than the longer of the ends has: the weakest, of equal ones the last, is left out.
  const double sum = 0.875;
  EXPECT_EQ(run_at({0, 1, 0}), (Run{{0, 0.5 / sum}, {3, 0.25 / sum}, {1, 0.125 / sum}}));
}

/// tubes() with all that vertices can carry for a material; colours and coordinates are linear in the place.
CharacterMesh dressed_tubes() {
  CharacterMesh mesh = tubes();
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    const Vec3 &p = mesh.positions[v], &n = mesh.normals[v];
    mesh.second_texture_coordinates.push_back(second_coordinates_at(p));
    mesh.colours.push_back(colour_at(p));
    // One tube's picture lies upright, the other's is mirrored.
    const double side = v < mesh.parts[1].first_vertex ? 1.0 : -1.0;
    mesh.tangents.push_back(Vec4(side * Vec3(n.z, 0, -n.x), side));
  }
  return mesh;
}

TEST(Resample, ColoursAndCoordinatesAtAMidpointAreTheMeanOfBothEnds) {
  const CharacterMesh coarse = dressed_tubes();
  for (const std::size_t wanted : {coarse.vertices() + edges_of(coarse), std::size_t{70}}) {
    const CharacterMesh other = resample(coarse, wanted).value();
    expect_sound(other);
    ASSERT_EQ(other.colours.size(), other.vertices());
    ASSERT_EQ(other.second_texture_coordinates.size(), other.vertices());
    for (std::size_t v = 0; v < other.vertices(); ++v) {
      EXPECT_LT(glm::length(other.colours[v] - colour_at(other.positions[v])), 1e-15);
      EXPECT_LT(glm::length(other.second_texture_coordinates[v] - second_coordinates_at(other.positions[v])), 1e-15);
    }
  }
}

TEST(Resample, TangentsAtAMidpointLieBetweenBothEnds) {
  const CharacterMesh coarse = dressed_tubes();
  for (const std::size_t wanted : {coarse.vertices() + edges_of(coarse), std::size_t{70}}) {
    const CharacterMesh other = resample(coarse, wanted).value();
    ASSERT_EQ(other.tangents.size(), other.vertices());
    for (std::size_t v = 0; v < other.vertices(); ++v) {
      const double side = v < other.parts[1].first_vertex ? 1.0 : -1.0;
      const Vec3& n = other.normals[v];  // round the tube, as the mean of two normals is the mean of two tangents
      EXPECT_EQ(other.tangents[v].w, side);
      EXPECT_LT(glm::length(Vec3(other.tangents[v]) - side * Vec3(n.z, 0, -n.x)), 1e-14);
    }
  }
}

TEST(Resample, OppositeTangentsLeaveTheFirst) {
  CharacterMesh mesh = one_triangle();
  mesh.tangents = {{1, 0, 0, 1}, {-1, 0, 0, -1}, {0, 1, 0, 1}};
  const CharacterMesh fine = resample(mesh, 6).value();
  for (std::size_t v = 0; v < 6; ++v) {
    EXPECT_NEAR(glm::length(Vec3(fine.tangents[v])), 1.0, 1e-15);
    if (fine.positions[v] == Vec3(1, 0, 0)) {
      EXPECT_EQ(fine.tangents[v], Vec4(1, 0, 0, 1));
    }
  }
}

TEST(Resample, ReachesAboutTheNumberAskedFor) {
  const CharacterMesh coarse = tubes();
  for (const std::size_t wanted : {50u, 100u, 500u, 2000u, 20000u}) {
    const CharacterMesh result = resample(coarse, wanted).value();
    // Collapses aim at triangles, of which an open tube has not quite two a vertex; its rims are kept.
    EXPECT_NEAR(static_cast<double>(result.vertices()), static_cast<double>(wanted), 0.15 * wanted + 10) << wanted;
    EXPECT_EQ(result.parts.size(), coarse.parts.size());
    EXPECT_EQ(result.palette.size(), coarse.palette.size());
    EXPECT_EQ(result.morph_slots.size(), coarse.morph_slots.size());
    expect_sound(result);
  }
}

TEST(Resample, KeepsOnlyVerticesThatTrianglesUseAndTheirOwnData) {
  const CharacterMesh coarse = tubes(), sparse = resample(coarse, 70).value();
  EXPECT_LT(sparse.vertices(), coarse.vertices());
  EXPECT_NEAR(area_of(sparse), area_of(coarse), 0.2 * area_of(coarse)) << "tubes of fewer sides are thinner";
  std::vector<bool> used(sparse.vertices());
  for (const std::uint32_t index : sparse.triangles) used[index] = true;
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
  for (std::uint32_t v = 0; v < sparse.parts[0].vertex_count; ++v) {
    const MorphDelta& delta = sparse.morph_deltas[sparse.morph_first[v]];
    EXPECT_LT(glm::length(delta.position - morphed_by(sparse.positions[v])), 1e-15);
  }
}

TEST(Resample, TheSameNumberChangesNothing) {
  const CharacterMesh mesh = tubes(), same = resample(mesh, mesh.vertices()).value();
  EXPECT_EQ(same.positions, mesh.positions);
  EXPECT_EQ(same.triangles, mesh.triangles);
}

TEST(Resample, WithoutTrianglesThereIsNothingToSplit) {
  CharacterMesh mesh = tubes();
  mesh.triangles.clear();
  const auto result = resample(mesh, 1000);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::bad_input);
  EXPECT_NE(result.error().message.find("without triangles"), std::string::npos);
}

}  // namespace
}  // namespace sinew::test
