#include "engine/deform/rigid_split.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/support/test_character.h"
#include "tests/support/tube.h"

namespace sinew::test {
namespace {

/// Vertices 0, 1, ... that each follow the one joint given.
CharacterMesh mesh_of(const std::vector<std::uint32_t>& joints, const std::vector<std::uint32_t>& triangles) {
  CharacterMesh mesh;
  mesh.positions.resize(joints.size());
  mesh.normals.resize(joints.size());
  for (const std::uint32_t joint : joints) mesh.influences.add_vertex({{joint, 1.0}});
  mesh.triangles = triangles;
  return mesh;
}

using Copies = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Copies copies_of(const RigidSplit& split) {
  Copies copies;
  for (const RigidDuplicate& d : split.duplicates) copies.emplace_back(d.vertex, d.joint);
  return copies;
}

using Indices = std::vector<std::uint32_t>;

TEST(RigidSplit, MostCornersDecideWhereverTheyStand) {
  for (const auto& [joints, odd] : {std::pair<Indices, std::uint32_t>{{7, 7, 9}, 2}, {{7, 9, 7}, 1}, {{9, 7, 7}, 0}}) {
    const RigidSplit split = split_by_bone(mesh_of(joints, {0, 1, 2}));
    EXPECT_EQ(copies_of(split), (Copies{{odd, 7}}));
    Indices expected{0, 1, 2};
    expected[odd] = 3;
    EXPECT_EQ(split.triangles, expected);
  }
}

TEST(RigidSplit, OfThreeDifferentBonesTheFirstCornersLeads) {
  const RigidSplit split = split_by_bone(mesh_of({5, 3, 4}, {0, 1, 2}));
  EXPECT_EQ(copies_of(split), (Copies{{1, 5}, {2, 5}}));
  EXPECT_EQ(split.triangles, (Indices{0, 3, 4}));
}

TEST(RigidSplit, TrianglesOfOneBoneStayAsTheyAre) {
  const RigidSplit split = split_by_bone(mesh_of({2, 2, 2, 6, 6, 6}, {0, 1, 2, 5, 4, 3}));
  EXPECT_TRUE(split.duplicates.empty());
  EXPECT_EQ(split.triangles, (Indices{0, 1, 2, 5, 4, 3}));
  EXPECT_TRUE(split_by_bone(CharacterMesh()).triangles.empty());
}

TEST(RigidSplit, NeighboursShareACopyButOnlyOfTheSameBone) {
  // Vertex 4 follows joint 1; two triangles of joint 0 and one of joint 2 need it.
  const RigidSplit split = split_by_bone(mesh_of({0, 0, 0, 2, 1, 2}, {0, 1, 4, 1, 2, 4, 3, 5, 4}));
  EXPECT_EQ(copies_of(split), (Copies{{4, 0}, {4, 2}}));
  EXPECT_EQ(split.triangles, (Indices{0, 1, 6, 1, 2, 6, 3, 5, 7}));
}

TEST(RigidSplit, EveryTriangleOfABentLimbKeepsItsShape) {
  const TestCharacter limb(tube());
  const Pose pose = limb.turned(tube_lower, {100, 0, 0});
  const std::vector<Mat34> palette = limb.palette(pose);
  const RigidSplit split = split_by_bone(limb.mesh);
  ASSERT_EQ(split.triangles.size(), limb.mesh.triangles.size());
  std::vector<Vec3> positions = deformed(limb, pose, {.bulge = BulgeMode::off, .deformer = Deformer::rigid}).positions;
  for (const RigidDuplicate& d : split.duplicates)
    positions.push_back(palette[d.joint].transform_point(limb.mesh.positions[d.vertex]));
  for (std::size_t i = 0; i < split.triangles.size(); ++i) {
    const std::size_t next = i - i % 3 + (i + 1) % 3;
    const double bind =
        glm::distance(limb.mesh.positions[limb.mesh.triangles[i]], limb.mesh.positions[limb.mesh.triangles[next]]);
    EXPECT_NEAR(glm::distance(positions[split.triangles[i]], positions[split.triangles[next]]), bind, 1e-14);
  }
}

TEST(RigidSplit, EachTriangleKeepsItsVerticesAndNoCopyIsMadeTwice) {
  const TestCharacter limb(tube());
  const RigidSplit split = split_by_bone(limb.mesh);
  std::set<std::pair<std::uint32_t, std::uint32_t>> distinct;
  for (const RigidDuplicate& d : split.duplicates) {
    EXPECT_TRUE(distinct.insert({d.vertex, d.joint}).second);
    EXPECT_NE(limb.mesh.influences.entries[limb.mesh.influences.first[d.vertex]].joint, d.joint);
  }
  std::set<std::uint32_t> used;
  for (std::size_t i = 0; i < split.triangles.size(); ++i) {
    const std::uint32_t index = split.triangles[i];
    const bool own = index < limb.mesh.vertices();
    EXPECT_EQ(own ? index : split.duplicates[index - limb.mesh.vertices()].vertex, limb.mesh.triangles[i]);
    if (!own) used.insert(index);
  }
  EXPECT_EQ(used.size(), split.duplicates.size());
  EXPECT_EQ(split.duplicates.size(), 96u) << "both rings at the border of upper and twist, and of twist and lower";
}

}  // namespace
}  // namespace sinew::test
