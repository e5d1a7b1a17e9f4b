#include <gtest/gtest.h>

#include "tests/support/gltf_builder.h"

namespace sinew::test {
namespace {

/// Three vertices with these four weights each, stored as type T, on joints 0 to 3.
template <class T>
Result<Model> with_weights(const std::vector<double>& weights, double one) {
  GltfBuilder b;
  auto primitive = b.triangle();
  primitive["attributes"]["JOINTS_0"] = b.integers<unsigned char>("VEC4", {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3});
  std::vector<double> stored;
  for (int v = 0; v < 3; ++v)
    for (const double w : weights) stored.push_back(one == 1.0 ? w : std::round(w * one));
  primitive["attributes"]["WEIGHTS_0"] = one == 1.0 ? b.floats("VEC4", stored) : b.integers<T>("VEC4", stored, true);
  b.draw(primitive, 4);
  return b.read();
}

std::vector<Influence> run_of(const Model& model, std::size_t v) {
  const Influences& i = model.meshes[0].primitives[0].influences;
  return {i.entries.begin() + i.first[v], i.entries.begin() + i.first[v + 1]};
}

TEST(GltfWeights, EveryComponentTypeGivesTheSameWithinItsSteps) {
  const std::vector<double> weights = {0.2, 0.4, 0.0, 0.4};
  const auto floats = with_weights<float>(weights, 1.0);
  const auto bytes = with_weights<unsigned char>(weights, 255.0);
  const auto shorts = with_weights<unsigned short>(weights, 65535.0);
  ASSERT_TRUE(floats && bytes && shorts);
  for (const Model* model : {&*floats, &*bytes, &*shorts}) {
    EXPECT_TRUE(model->problems.empty());
    const auto run = run_of(*model, 2);
    ASSERT_EQ(run.size(), 3u);
    EXPECT_EQ(run[0].joint, 1u);  // equal weights: the order of the joint list
    EXPECT_EQ(run[1].joint, 3u);
    EXPECT_EQ(run[2].joint, 0u);
    const double step = model == &*floats ? 1e-7 : model == &*bytes ? 0.5 / 255 : 0.5 / 65535;
    EXPECT_NEAR(run[0].weight, 0.4, step);
    EXPECT_NEAR(run[2].weight, 0.2, step);
    EXPECT_NEAR(run[0].weight + run[1].weight + run[2].weight, 1.0, 1e-15);
  }
}

TEST(GltfWeights, SumsAreNormalisedAndTheWorstIsTold) {
  const auto model = with_weights<float>({0.05, 0.05, 0.0, 0.0}, 1.0);
  ASSERT_TRUE(model);
  EXPECT_DOUBLE_EQ(run_of(*model, 0)[0].weight, 0.5);
  ASSERT_EQ(model->problems.size(), 1u);
  EXPECT_EQ(model->problems[0], "meshes/0/primitives/0: 3 vertices' weights did not sum to 1 (worst 0.1); normalised");
}

TEST(GltfWeights, NothingLeftIsAnEmptyRun) {
  const auto model = with_weights<float>({0, 0, 0, 0}, 1.0);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->meshes[0].primitives[0].influences.vertices(), 3u);
  EXPECT_TRUE(run_of(*model, 1).empty());
  EXPECT_TRUE(mentions(*model, "3 vertices have no weights"));
}

TEST(GltfWeights, NegativeWeightsCountAsNoneAndNoNumbersAreRefused) {
  const auto negative = with_weights<float>({1, -0.5, 0, 0}, 1.0);
  ASSERT_TRUE(negative);
  EXPECT_EQ(run_of(*negative, 0).size(), 1u);
  EXPECT_TRUE(mentions(*negative, "negative weights"));
  const auto no_number = with_weights<float>({1, NAN, 0, 0}, 1.0);
  ASSERT_FALSE(no_number);
  EXPECT_NE(no_number.error().message.find("vertex 0 is not finite"), std::string::npos);
}

TEST(GltfWeights, OfTwelveInfluencesTheStrongestEightAreKept) {
  GltfBuilder b;
  auto primitive = b.triangle();
  for (int set = 0; set < 3; ++set) {
    std::vector<double> joints, weights;
    for (int v = 0; v < 3; ++v)
      for (int k = 0; k < 4; ++k) {
        joints.push_back(4 * set + k);
        weights.push_back((4 * set + k + 1) / 78.0);
      }
    primitive["attributes"]["JOINTS_" + std::to_string(set)] = b.integers<unsigned short>("VEC4", joints);
    primitive["attributes"]["WEIGHTS_" + std::to_string(set)] = b.floats("VEC4", weights);
  }
  b.draw(primitive, 12);
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  const auto run = run_of(*model, 0);
  ASSERT_EQ(run.size(), max_influences);
  double sum = 0.0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    EXPECT_EQ(run[i].joint, 11 - i);
    EXPECT_NEAR(run[i].weight, (12.0 - static_cast<double>(i)) / 68.0, 1e-7);
    sum += run[i].weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-14);
  EXPECT_TRUE(
      mentions(*model, "3 vertices had more than 8 joints; the strongest are kept (worst weight dropped 0.128)"));
}

TEST(GltfWeights, AJointNamedTwiceIsMerged) {
  GltfBuilder b;
  auto primitive = b.triangle();
  primitive["attributes"]["JOINTS_0"] = b.integers<unsigned char>("VEC4", {1, 0, 1, 9, 1, 0, 1, 9, 1, 0, 1, 9});
  primitive["attributes"]["WEIGHTS_0"] = b.floats("VEC4", {0.25, 0.25, 0.5, 0, 0.25, 0.25, 0.5, 0, 0.25, 0.25, 0.5, 0});
  b.draw(primitive, 2);
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;  // joint 9 has no weight: it does not count
  const auto run = run_of(*model, 0);
  ASSERT_EQ(run.size(), 2u);
  EXPECT_EQ(run[0].joint, 1u);
  EXPECT_DOUBLE_EQ(run[0].weight, 0.75);
  EXPECT_TRUE(mentions(*model, "name a joint twice"));
}

TEST(GltfWeights, JointsMustBeInEverySkinThatDrawsTheMesh) {
  GltfBuilder b;
  auto primitive = b.triangle();
  primitive["attributes"]["JOINTS_0"] = b.integers<unsigned char>("VEC4", {0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0});
  primitive["attributes"]["WEIGHTS_0"] = b.floats("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  b.draw(primitive, 4);
  const auto first = b.read();
  ASSERT_TRUE(first) << first.error().message;
  b.add("skins", {{"joints", {0, 1, 2}}});
  b.add("nodes", {{"mesh", 0}, {"skin", 1}});
  const auto second = b.read();
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message.find("nodes/5: meshes/0, triangle primitive 0, vertex 1 is weighted to joint 3, but "
                                        "skins/1 has 3"),
            std::string::npos)
      << second.error().message;
}

TEST(GltfWeights, SkinWithoutWeightsIsTakenFromTheNode) {
  GltfBuilder b;
  b.draw(b.triangle(), 1);
  const auto model = b.read();
  ASSERT_TRUE(model);
  EXPECT_EQ(model->nodes[1].skin, -1);
  EXPECT_TRUE(mentions(*model, "has a skin, but meshes/0 has no weights"));
}

}  // namespace
}  // namespace sinew::test
