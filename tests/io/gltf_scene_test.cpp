#include "engine/io/gltf_scene.h"

#include <gtest/gtest.h>

#include "tests/support/gltf_builder.h"

namespace sinew::test {
namespace {

using nlohmann::json;

TEST(GltfScene, HierarchyAndScenes) {
  GltfBuilder b;
  b.json["nodes"] = {{{"children", {2}}}, json::object(), json::object()};
  EXPECT_EQ(b.read()->roots, (std::vector<int>{0, 1}));
  EXPECT_EQ(b.read()->nodes[2].parent, 0);
  b.json["scenes"] = {{{"nodes", {1}}}, {{"nodes", {1, 0}}}};
  EXPECT_EQ(b.read()->roots, (std::vector<int>{1}));
  b.json["scene"] = 1;
  EXPECT_EQ(b.read()->roots, (std::vector<int>{1, 0}));
  b.json["scenes"][0]["nodes"] = {2};
  expect_refused(b, "scenes/0/nodes: node 2 is not a root");
}

TEST(GltfScene, CyclesAndSecondParentsAreRefused) {
  GltfBuilder b;
  b.json["nodes"] = {{{"children", {1}}}, {{"children", {0}}}};
  expect_refused(b, "is its own ancestor");
  b.json["nodes"] = {{{"children", {0}}}};
  expect_refused(b, "nodes/0: is its own ancestor");
  b.json["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, json::object()};
  expect_refused(b, "nodes/1/children: node 2 is a child of node 0 already");
  b.json["nodes"] = {{{"children", {7}}}};
  expect_refused(b, "nodes/0/children/0: refers to nodes 7, but there are 1");
}

TEST(GltfScene, AChainOfManyNodesIsWalkedWithoutRecursion) {
  GltfBuilder b;
  b.json["nodes"] = json::array();
  constexpr int count = 150000;
  for (int i = 0; i < count; ++i)
    b.json["nodes"].push_back(i + 1 < count ? json{{"children", {i + 1}}} : json::object());
  b.json["skins"] = {{{"joints", {0, count - 1}}}};
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->nodes.back().parent, count - 2);
}

TEST(GltfScene, MatricesAreTakenApart) {
  Transform t;
  t.translation = {1, 2, 3};
  t.rotation = rotation_xyz_degrees({20, 30, 40});
  for (const Vec3& scale : {Vec3(1, 2, 3), Vec3(-1, 2, 3), Vec3(-2, -2, -2), Vec3(1, 0, 1), Vec3(1e-4, 1e-4, 1e-4)}) {
    t.scale = scale;
    const Mat4 expected = t.matrix();
    const Mat4 recomposed = gltf::decompose(expected).matrix();
    for (int c = 0; c < 4; ++c) EXPECT_LT(glm::distance(expected[c], recomposed[c]), 1e-12);
  }
}

TEST(GltfScene, ShearIsKeptAsAMatrixWithAWord) {
  GltfBuilder b;
  b.add("nodes", {{"matrix", {1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1}}});
  b.add("nodes", {{"matrix", {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 4, 5, 6, 1}}});
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  ASSERT_TRUE(model->nodes[0].matrix);
  EXPECT_EQ((*model->nodes[0].matrix)[1][0], 0.5);
  EXPECT_TRUE(mentions(*model, "nodes/0/matrix: has shear"));
  EXPECT_FALSE(model->nodes[1].matrix);
  EXPECT_LT(glm::distance(model->nodes[1].rest.scale, Vec3(2)), 1e-12);
}

TEST(GltfScene, RotationsAreNormalised) {
  GltfBuilder b;
  b.add("nodes", {{"rotation", {0, 0, 0, 0}}});
  b.add("nodes", {{"rotation", {0, 2, 0, 0}}});
  b.add("nodes", {{"rotation", {0, 1e30, 0, 1e30}}});
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->nodes[0].rest.rotation, Quat(1, 0, 0, 0));
  EXPECT_EQ(model->nodes[1].rest.rotation, Quat(0, 0, 1, 0));
  EXPECT_NEAR(glm::length(model->nodes[2].rest.rotation), 1.0, 1e-12);
  EXPECT_TRUE(mentions(*model, "nodes/1/rotation: a quaternion of length 2; normalised"));
}

TEST(GltfScene, SkinsAndTheirMatrices) {
  GltfBuilder b;
  b.json["nodes"] = {json::object(), json::object()};
  b.json["skins"] = {{{"joints", {1, 0}}, {"name", "s"}}};
  auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->skins[0].inverse_bind, (std::vector<Mat4>(2, Mat4(1.0))));
  EXPECT_TRUE(mentions(*model, "no common root"));

  b.json["skins"][0]["joints"] = {1, 1};
  expect_refused(b, "skins/0/joints/1: node 1 stands in the list already");
  b.json["skins"][0]["joints"] = {0, 1};
  std::vector<double> matrices(16, 0.0);
  b.json["skins"][0]["inverseBindMatrices"] = b.floats("MAT4", matrices);
  expect_refused(b, "1 matrices for 2 joints");
  matrices.resize(32, 0.0);
  b.json["skins"][0]["inverseBindMatrices"] = b.floats("MAT4", matrices);
  model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(mentions(*model, "2 matrices flatten the mesh"));
  EXPECT_TRUE(mentions(*model, "2 matrices whose last row"));
  matrices[20] = NAN;
  b.json["skins"][0]["inverseBindMatrices"] = b.floats("MAT4", matrices);
  expect_refused(b, "matrix 1 has a number that is not finite");
}

}  // namespace
}  // namespace sinew::test
