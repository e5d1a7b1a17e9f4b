#include "engine/io/rig_layout.h"

#include <gtest/gtest.h>

#include "tests/support/rig_round_trip.h"
#include "tests/support/small_rig.h"

namespace sinew {
namespace {

using namespace test;

TEST(RigLayout, NodesAndSkinsKeepTheirIndices) {
  const Model model = two_meshes_on_one_skin(), back = written_and_read(model);
  ASSERT_EQ(back.nodes.size(), model.nodes.size() + 1);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) EXPECT_EQ(back.nodes[i].name, model.nodes[i].name);
  EXPECT_EQ(back.nodes[prop_node].mesh, 2);
  ASSERT_EQ(back.skins.size(), 1u);
  EXPECT_EQ(back.skins[0].joints, model.skins[0].joints);
  EXPECT_EQ(back.skins[0].inverse_bind, model.skins[0].inverse_bind);
}

TEST(RigLayout, SkinnedMeshesStandOnRootsWithoutTransform) {
  const Model back = written_and_read(two_meshes_on_one_skin());
  const int split = static_cast<int>(back.nodes.size()) - 1;
  EXPECT_EQ(back.nodes[clothes_node].mesh, -1) << "its child needs the node, so the mesh moves to a new one";
  EXPECT_EQ(back.nodes[clothes_node].rest.translation, Vec3(5.0));
  for (const int node : {body_node, split}) {
    EXPECT_EQ(back.nodes[node].parent, -1);
    EXPECT_EQ(back.nodes[node].skin, 0);
    EXPECT_EQ(back.nodes[node].rest_local(), Mat4(1.0));
  }
}

/// The prop, drawn between two skinned meshes, stays inside its tree: the others stand around that.
TEST(RigLayout, DrawsInTheModelsOrder) {
  Model model = two_meshes_on_one_skin();
  std::vector<int>& children = model.nodes[0].children;
  ASSERT_EQ(children, (std::vector<int>{body_node, hip, clothes_node}));
  std::vector<std::string> names;
  for (const MeshPart& part : character_mesh(written_and_read(model)).parts) names.push_back(part.mesh);
  EXPECT_EQ(names, (std::vector<std::string>{"body", "body", "prop", "clothes"}));
}

TEST(RigLayout, VerticesWithoutInfluencesFollowTheirNode) {
  Model model = two_meshes_on_one_skin();
  Primitive& primitive = model.meshes[1].primitives[0];
  Influences loose;
  for (std::size_t v = 0; v < primitive.positions.size(); ++v)
    loose.add_vertex(v % 2 == 0 ? std::vector<Influence>{} : std::vector<Influence>{{1, 1.0}});
  primitive.influences = loose;
  model.meshes[0].primitives[1].influences = {};
  model.clips[0].channels.push_back(channel(clothes_node, ChannelPath::rotation, Interpolation::linear, 4));
  const Model back = written_and_read(model);
  EXPECT_EQ(back.skins[0].joints.size(), joint_count + 2);
  expect_same_deformation(model, back);
}

TEST(RigLayout, AMeshOnAJointFollowsItToo) {
  Model model = two_meshes_on_one_skin();
  std::swap(model.nodes[clothes_node].mesh, model.nodes[first_joint].mesh);
  std::swap(model.nodes[clothes_node].skin, model.nodes[first_joint].skin);
  model.meshes[1].primitives[0].influences.first.assign(model.meshes[1].primitives[0].positions.size() + 1, 0);
  model.meshes[1].primitives[0].influences.entries.clear();
  model.meshes[1].primitives.push_back(strip(3, 4, 0));
  const Model back = written_and_read(model);
  EXPECT_EQ(back.skins[0].joints.size(), joint_count + 1);
  expect_same_deformation(model, back);
}

TEST(RigLayout, ShearIsWrittenAsAChain) {
  Model model = two_meshes_on_one_skin();
  Mat4 shear(1.0);
  shear[1] = Vec4(0.5, 1.0, 0.25, 0.0);
  shear[2] = Vec4(0.0, 0.0, -2.0, 0.0);
  Node& node = model.nodes[hip];
  node.matrix = node.rest.matrix() * shear;
  (*node.matrix)[3] = Vec4(node.rest.translation, 1.0);
  model.clips[0].channels.push_back(channel(hip, ChannelPath::rotation, Interpolation::step, 4));
  const Model back = written_and_read(model);
  EXPECT_EQ(back.nodes[hip].name, "hip");
  expect_same_deformation(model, back);
}

TEST(RigLayout, JointTreesApartGetOneRoot) {
  Model model = two_meshes_on_one_skin();
  const int second = link(model, -1, named("second tree", moved(0, 1, 0)));
  const int unseen = link(model, -1, named("outside the scene", moved(0, 0, 4)));
  model.roots.pop_back();
  for (const int node : {second, unseen}) {
    model.skins[0].joints.push_back(node);
    model.skins[0].inverse_bind.push_back(Mat4(1.0));
  }
  model.meshes[0].primitives[0].influences.entries[0].joint = joint_count;
  model.meshes[0].primitives[0].influences.entries[1].joint = joint_count + 1;
  const Model back = written_and_read(model);
  EXPECT_GE(back.nodes[second].parent, 0);
  EXPECT_EQ(back.nodes[second].parent, back.nodes[unseen].parent);
  expect_same_deformation(model, back);
}

TEST(RigLayout, WhatTheSceneDoesNotShowIsLeftOut) {
  Model model = two_meshes_on_one_skin();
  link(model, -1, drawing("hidden", 2, -1));
  model.roots.pop_back();
  model.nodes[prop_node].mesh = -1;
  const Model back = written_and_read(model);
  EXPECT_EQ(back.meshes.size(), 2u);
  EXPECT_EQ(back.nodes.size(), model.nodes.size() + 1);
}

}  // namespace
}  // namespace sinew
