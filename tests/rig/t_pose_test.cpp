#include "engine/rig/t_pose.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/body/figure.h"
#include "engine/io/gltf_read.h"
#include "engine/model/character_mesh.h"
#include "engine/rig/pose.h"
#include "tests/support/assets.h"
#include "tests/support/rig_round_trip.h"

namespace sinew::test {
namespace {

using enum HumanoidBone;

std::vector<Mat4> rest_of(const Model& model) {
  return global_transforms(model, hierarchy_order(model), rest_pose(model));
}

Vec3 direction(const Model& model, const Humanoid& humanoid, HumanoidBone from, HumanoidBone to) {
  const std::vector<Mat4> rest = rest_of(model);
  return glm::normalize(Vec3(rest[humanoid.find(to)][3] - rest[humanoid.find(from)][3]));
}

void expect_t_pose(const Model& model, const Humanoid& humanoid) {
  const Vec3 left(1, 0, 0), down(0, -1, 0);
  for (const auto& [from, to, wanted] : {std::tuple{left_upper_arm, left_lower_arm, left},
                                         {left_lower_arm, left_hand, left},
                                         {right_upper_arm, right_lower_arm, -left},
                                         {right_lower_arm, right_hand, -left},
                                         {left_upper_leg, left_lower_leg, down},
                                         {right_lower_leg, right_foot, down}})
    EXPECT_LT(angle_degrees(direction(model, humanoid, from, to), wanted), 1e-4) << humanoid_name(from);
  EXPECT_GT(body_front(model, humanoid, rest_of(model)).z, 0.9);
  // The rest pose is the bind pose: what is drawn are the vertices as they stand in the file.
  const CharacterMesh mesh = character_mesh(model);
  const std::vector<Vec3> drawn = skinned_positions(model, rest_pose(model));
  Bounds bounds;
  for (std::size_t v = 0; v < drawn.size(); ++v) bounds.add(drawn[v]);
  for (const Skin& skin : model.skins)
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      const Mat4 still = rest_of(model)[skin.joints[j]] * skin.inverse_bind[j];
      for (int column = 0; column < 4; ++column)
        ASSERT_LT(glm::length(still[column] - Mat4(1.0)[column]), 1e-9) << "joint " << j;
    }
  EXPECT_NEAR(bounds.low.y, 0.0, 1e-9);
}

TEST(TPose, AFigureStandsInIt) {
  const auto figure = build_figure(*figure_preset("skeleton"));
  ASSERT_TRUE(figure);
  const Humanoid humanoid = find_humanoid(*figure, rest_of(*figure));
  const auto posed = in_t_pose(*figure, humanoid);
  ASSERT_TRUE(posed) << posed.error().message;
  expect_t_pose(*posed, humanoid);
  // Upright limbs change the height only by the legs' lean; the arms reach further than in the A pose.
  Bounds before, after;
  for (const Vec3& p : figure->meshes[0].primitives[0].positions) before.add(p);
  for (const Vec3& p : posed->meshes[0].primitives[0].positions) after.add(p);
  EXPECT_NEAR(after.high.y, before.high.y, 0.02);
  EXPECT_GT(after.high.x, before.high.x + 0.2);
  for (const Vec3& n : posed->meshes[0].primitives[0].normals) ASSERT_NEAR(glm::length(n), 1.0, 1e-12);
  // In a T pose nothing is left to turn.
  const auto again = in_t_pose(*posed, humanoid);
  ASSERT_TRUE(again);
  for (std::size_t v = 0; v < posed->meshes[0].primitives[0].positions.size(); ++v)
    ASSERT_LT(glm::distance(posed->meshes[0].primitives[0].positions[v], again->meshes[0].primitives[0].positions[v]),
              1e-6);
}

TEST(TPose, AModelThatFacesBackwardsIsTurned) {
  auto figure = build_figure(*figure_preset("skeleton"));
  ASSERT_TRUE(figure);
  const Quat half_turn = glm::angleAxis(std::numbers::pi, Vec3(0, 1, 0));
  Node& root = figure->nodes[figure->roots[0]];
  root.rest.rotation = half_turn;
  root.rest.translation = half_turn * root.rest.translation;
  const Humanoid humanoid = find_humanoid(*figure, rest_of(*figure));
  const auto posed = in_t_pose(*figure, humanoid);
  ASSERT_TRUE(posed) << posed.error().message;
  expect_t_pose(*posed, humanoid);
}

TEST(TPose, WhatIsNoHumanoidIsRefused) {
  Model model;
  model.file = "box.glb";
  model.nodes.emplace_back();
  model.roots = {0};
  const auto result = in_t_pose(model, find_humanoid(model, rest_of(model)));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::bad_input);
  EXPECT_NE(result.error().message.find("leftUpperArm"), std::string::npos) << result.error().message;
}

TEST(TPose, RealCharactersStandInIt) {
  SINEW_ASSETS_OR_SKIP(folder);
  for (const char* name : {"makehuman/mh_male_game.glb", "mesh2motion/human-male.glb", "khronos/CesiumMan.glb"}) {
    SCOPED_TRACE(name);
    const auto model = read_gltf(folder / "characters" / name);
    ASSERT_TRUE(model) << model.error().message;
    const Humanoid humanoid = find_humanoid(*model, rest_of(*model));
    const auto posed = in_t_pose(*model, humanoid);
    ASSERT_TRUE(posed) << posed.error().message;
    expect_t_pose(*posed, humanoid);
  }
}

}  // namespace
}  // namespace sinew::test
