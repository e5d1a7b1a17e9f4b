#include "engine/rig/pose.h"

#include <random>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/small_rig.h"

namespace sinew::test {
namespace {

/// Roundings along chains of ten matrices of numbers of size one.
constexpr double rounding = 1e-12;

double largest_difference(const Mat4& a, const Mat4& b) {
  double largest = 0.0;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
  return largest;
}

class Random {
 public:
  double number() { return distribution_(engine_); }
  Vec3 vector() { return {number(), number(), number()}; }
  Quat rotation() { return rotation_xyz_degrees(180.0 * vector()); }
  std::size_t index(std::size_t count) { return engine_() % count; }

 private:
  std::mt19937 engine_{5};
  std::uniform_real_distribution<double> distribution_{-1.0, 1.0};
};

/// A tree of nodes in a scrambled order, some with scale; `scaled` of 0 leaves every scale at 1.
Model random_tree(Random& random, int nodes, double scaled) {
  Model model;
  std::vector<int> place(nodes);
  for (int i = 0; i < nodes; ++i) place[i] = i * 7 % nodes;
  model.nodes.resize(nodes);
  for (int i = 0; i < nodes; ++i) {
    Node& node = model.nodes[place[i]];
    node.rest = {random.vector(), random.rotation(), Vec3(1) + scaled * random.vector()};
    if (i > 0) node.parent = place[random.index(i)];
    (i > 0 ? model.nodes[node.parent].children : model.roots).push_back(place[i]);
  }
  return model;
}

/// What a global transform does to a point, by hand: node by node upwards, scale, turn, move.
Vec3 carried(const Model& model, const Pose& pose, int node, Vec3 p) {
  for (; node >= 0; node = model.nodes[node].parent) {
    const Transform& t = pose.local[node];
    const Quat turned = t.rotation * Quat(0, t.scale * p) * glm::conjugate(t.rotation);
    p = Vec3(turned.x, turned.y, turned.z) + t.translation;
  }
  return p;
}

TEST(Pose, ForwardKinematicsCarriesPointsUpTheHierarchy) {
  Random random;
  const Model model = random_tree(random, 40, 0.4);
  Pose pose = rest_pose(model);
  for (Transform& local : pose.local) local = {random.vector(), random.rotation(), Vec3(1) + 0.4 * random.vector()};
  for (const Pose& each : {rest_pose(model), pose}) {
    const std::vector<Mat4> global = global_transforms(model, hierarchy_order(model), each);
    for (int node = 0; node < 40; ++node)
      for (int i = 0; i < 4; ++i) {
        const Vec3 p = random.vector();
        EXPECT_LT(glm::length(Vec3(global[node] * Vec4(p, 1)) - carried(model, each, node, p)), rounding);
      }
  }
}

TEST(Pose, ASharedAncestorMovesEverythingBelowItRigidly) {
  Random random;
  const Model model = random_tree(random, 20, 0.3);
  const std::vector<int> order = hierarchy_order(model);
  Pose pose = rest_pose(model);
  const int root = model.roots[0];
  const Transform motion{random.vector(), random.rotation(), Vec3(1)};
  pose.local[root].rotation = motion.rotation * pose.local[root].rotation;
  pose.local[root].translation = motion.rotation * pose.local[root].translation + motion.translation;
  const std::vector<Mat4> before = global_transforms(model, order, rest_pose(model)),
                          after = global_transforms(model, order, pose);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT(largest_difference(after[i], motion.matrix() * before[i]), rounding);
}

TEST(Pose, AShearedNodeRestsInItsMatrixAndTurnsInFrontOfIt) {
  Model model;
  link(model, -1, named("sheared"));
  Node& node = model.nodes[0];
  node.matrix = Mat4(Vec4(1, 0.5, 0, 0), Vec4(0, 2, 0.25, 0), Vec4(0, 0, 1, 0), Vec4(3, 4, 5, 1));
  node.rest = {{3, 4, 5}, rotation_xyz_degrees({10, 20, 30}), Vec3(1, 2, 1)};
  Pose pose = rest_pose(model);
  const std::vector<int> order = hierarchy_order(model);
  EXPECT_LT(largest_difference(global_transforms(model, order, pose)[0], *node.matrix), rounding);
  turn_joint(model, rest_rotations(model, order), 0, {0, 0, 90}, pose);
  Mat4 expected = glm::rotate(Mat4(1.0), 90 * degrees_to_radians, {0, 0, 1}) * Mat4(Mat3(*node.matrix));
  expected[3] = Vec4(3, 4, 5, 1);
  EXPECT_LT(largest_difference(global_transforms(model, order, pose)[0], expected), rounding);
}

TEST(Pose, MorphWeightsAreTheNodesOrElseTheMeshs) {
  const Model model = two_meshes_on_one_skin();
  EXPECT_EQ(rest_pose(model).morph_weights[body_node], (std::vector<double>{0.25, 0.5}));
  Model plain = model;
  plain.nodes[body_node].morph_weights.clear();
  EXPECT_EQ(rest_pose(plain).morph_weights[body_node], (std::vector<double>{0.0, 1.0}));
  plain.meshes[0].morph_weights.clear();
  EXPECT_EQ(rest_pose(plain).morph_weights[body_node], (std::vector<double>{0.0, 0.0}));
  EXPECT_TRUE(rest_pose(plain).morph_weights[hip].empty());
}

TEST(Pose, SlotWeightsFollowTheMeshsSlots) {
  Model model = two_meshes_on_one_skin();
  link(model, -1, drawing("twin", 0, 0));
  Pose pose = rest_pose(model);
  pose.morph_weights.back() = {0.125};  // a short list: what it leaves out is 0
  EXPECT_EQ(morph_slot_weights(character_mesh(model), pose), (std::vector<double>{0.25, 0.5, 0.125, 0.0}));
}

TEST(Pose, TurnsAboutTheModelsAxesWhateverTheJointsOwn) {
  // With all above it at rest, a turned joint's global transform is R about the joint's place, in front of what it was.
  Random random;
  const Model model = random_tree(random, 30, 0.0);
  const std::vector<int> order = hierarchy_order(model);
  const std::vector<Mat4> rest = global_transforms(model, order, rest_pose(model));
  const std::vector<Quat> turns = rest_rotations(model, order);
  for (int node = 0; node < 30; ++node) {
    const Vec3 degrees = 180.0 * random.vector();
    Pose pose = rest_pose(model);
    turn_joint(model, turns, node, degrees, pose);
    const Vec3 place(rest[node][3]);
    const Mat4 about_place = glm::translate(Mat4(1.0), place) * glm::mat4_cast(rotation_xyz_degrees(degrees)) *
                             glm::translate(Mat4(1.0), -place);
    const std::vector<Mat4> posed = global_transforms(model, order, pose);
    EXPECT_LT(largest_difference(posed[node], about_place * rest[node]), rounding);
    for (const int child : model.nodes[node].children)
      EXPECT_LT(largest_difference(posed[child], about_place * rest[child]), rounding);
    EXPECT_NEAR(glm::length(pose.local[node].rotation), 1.0, 1e-15);
  }
}

TEST(Pose, ATurnIsFromTheRestPoseNotFromThePoseBefore) {
  Random random;
  const Model model = random_tree(random, 5, 0.2);
  const std::vector<Quat> turns = rest_rotations(model, hierarchy_order(model));
  Pose once = rest_pose(model), twice = rest_pose(model);
  turn_joint(model, turns, 3, {0, 50, 0}, twice);
  for (Pose* pose : {&once, &twice}) turn_joint(model, turns, 3, {30, 0, 0}, *pose);
  EXPECT_EQ(once.local[3].rotation, twice.local[3].rotation);
}

TEST(Pose, RestRotationsLeaveScaleOut) {
  Random random;
  Model scaled = random_tree(random, 30, 0.4), plain = scaled;
  for (Node& node : plain.nodes) node.rest.scale = Vec3(1);
  const std::vector<int> order = hierarchy_order(scaled);
  const std::vector<Quat> turns = rest_rotations(scaled, order);
  const std::vector<Mat4> global = global_transforms(plain, order, rest_pose(plain));
  for (std::size_t i = 0; i < turns.size(); ++i) {
    Mat4 turn = global[i];
    turn[3] = Vec4(0, 0, 0, 1);
    EXPECT_LT(largest_difference(glm::mat4_cast(turns[i]), turn), rounding);
  }
}

TEST(Palette, IsTheIdentityInTheBindPose) {
  Random random;
  Model model = random_tree(random, 12, 0.3);
  const std::vector<int> order = hierarchy_order(model);
  const std::vector<Mat4> global = global_transforms(model, order, rest_pose(model));
  CharacterMesh mesh;
  for (int node = 0; node < 12; ++node) mesh.palette.push_back({node, glm::inverse(global[node])});
  for (const Mat34& f : palette_transforms(mesh, global))
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) EXPECT_NEAR(f.row[row][column], row == column ? 1.0 : 0.0, rounding);
}

TEST(Palette, GoesFromTheBindPoseThroughTheJointToTheWorld) {
  Random random;
  Model model = random_tree(random, 12, 0.3);
  const Pose pose = rest_pose(model);
  const std::vector<Mat4> global = global_transforms(model, hierarchy_order(model), pose);
  CharacterMesh mesh;
  for (const int node : {4, 4, 9}) {
    const Transform bind{random.vector(), random.rotation(), Vec3(1.0) + 0.3 * random.vector()};
    mesh.palette.push_back({node, bind.matrix()});
  }
  const Transform placement{random.vector(), random.rotation(), Vec3(2)};
  const std::vector<Mat34> placed = palette_transforms(mesh, global, placement.matrix());
  ASSERT_EQ(placed.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 p = random.vector();
    const Vec3 at_joint(mesh.palette[i].inverse_bind * Vec4(p, 1));
    const Vec3 world(placement.matrix() * Vec4(carried(model, pose, mesh.palette[i].node, at_joint), 1));
    EXPECT_LT(glm::length(placed[i].transform_point(p) - world), rounding);
  }
}

}  // namespace
}  // namespace sinew::test
