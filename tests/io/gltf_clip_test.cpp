#include <gtest/gtest.h>

#include "tests/support/gltf_builder.h"

namespace sinew::test {
namespace {

using nlohmann::json;

/// One node and an animation with one channel on it.
GltfBuilder animated(int input, int output, const std::string& path, const std::string& interpolation, GltfBuilder b) {
  if (!b.json.contains("nodes")) b.add("nodes", json::object());
  b.add("animations", {{"name", "Walk"},
                       {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}},
                       {"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}}});
  return b;
}

TEST(GltfClip, ReadsPathsAndInterpolations) {
  GltfBuilder b;
  const int input = b.floats("SCALAR", {0, 0.5});
  const int output = b.floats("VEC3", {1, 2, 3, 4, 5, 6});
  const auto model = animated(input, output, "translation", "STEP", b).read();
  ASSERT_TRUE(model) << model.error().message;
  const Clip& clip = model->clips[0];
  EXPECT_EQ(clip.name, "Walk");
  EXPECT_EQ(clip.duration, 0.5);
  ASSERT_EQ(clip.channels.size(), 1u);
  EXPECT_EQ(clip.channels[0].interpolation, Interpolation::step);
  EXPECT_EQ(clip.channels[0].values, (std::vector<double>{1, 2, 3, 4, 5, 6}));
}

TEST(GltfClip, NormalizedRotations) {
  GltfBuilder b;
  const int input = b.floats("SCALAR", {0, 1});
  const int output = b.integers<short>("VEC4", {0, 0, 0, 32767, 23170, 0, 0, -23170}, true);
  const auto model = animated(input, output, "rotation", "LINEAR", b).read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(model->problems.empty());
  const Channel& channel = model->clips[0].channels[0];
  EXPECT_EQ(channel.width, 4u);
  EXPECT_NEAR(channel.values[4], std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(channel.values[7], -std::sqrt(0.5), 1e-12);
}

TEST(GltfClip, CubicSplinesKeepTheirTangents) {
  GltfBuilder b;
  const int input = b.floats("SCALAR", {0});
  const int output = b.floats("VEC4", {1, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 0});
  const auto model = animated(input, output, "rotation", "CUBICSPLINE", b).read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->clips[0].channels[0].values, (std::vector<double>{0.5, 0, 0, 0, 0, 0, 0, 1, 0, 0.5, 0, 0}));
  EXPECT_TRUE(mentions(*model, "1 keys with a quaternion not of length 1"));
}

TEST(GltfClip, MorphWeights) {
  GltfBuilder b;
  auto primitive = b.triangle();
  primitive["targets"] = {json::object(), json::object()};
  b.draw(primitive);
  const int input = b.floats("SCALAR", {0, 1});
  const int output = b.floats("SCALAR", {0, 1, 0.5, 0.25});
  const auto model = animated(input, output, "weights", "LINEAR", b).read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->clips[0].channels[0].width, 2u);
  const int short_output = b.floats("SCALAR", {0, 1, 0.5});
  const auto wrong = animated(input, short_output, "weights", "LINEAR", b).read();
  ASSERT_FALSE(wrong);
  EXPECT_NE(
      wrong.error().message.find("animations/0, weights of node 0: 2 keys need 4 output numbers, but there are 3"),
      std::string::npos)
      << wrong.error().message;
}

TEST(GltfClip, BadKeysAreDroppedWithAWord) {
  GltfBuilder b;
  const int input = b.floats("SCALAR", {0, 0, NAN, 1, 0.5, 2, 3});
  const int output =
      b.floats("VEC4", {0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, NAN, 0, 0, 1});
  const auto model = animated(input, output, "rotation", "LINEAR", b).read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->clips[0].channels[0].times, (std::vector<double>{0, 1}));
  EXPECT_EQ(model->clips[0].channels[0].values, (std::vector<double>{0, 0, 0, 1, 0, 1, 0, 0}));
  EXPECT_TRUE(mentions(*model, "3 keys whose times do not rise"));
  EXPECT_TRUE(mentions(*model, "1 keys with a quaternion of length 0"));
  EXPECT_TRUE(mentions(*model, "1 keys are not finite"));
}

TEST(GltfClip, UnknownAndDoubleChannelsAreLeftOutWithAWord) {
  GltfBuilder b;
  const int input = b.floats("SCALAR", {0});
  const int first = b.floats("VEC3", {1, 1, 1}), second = b.floats("VEC3", {2, 2, 2});
  b = animated(input, first, "scale", "LINEAR", b);
  b.json["animations"][0]["samplers"].push_back({{"input", input}, {"output", second}});
  for (const json& target : {json{{"node", 0}, {"path", "scale"}}, json{{"node", 0}, {"path", "visibility"}},
                             json{{"path", "pointer"}}, json{{"node", 0}, {"path", "weights"}}})
    b.json["animations"][0]["channels"].push_back({{"sampler", 1}, {"target", target}});
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  ASSERT_EQ(model->clips[0].channels.size(), 1u);
  EXPECT_EQ(model->clips[0].channels[0].values, (std::vector<double>{1, 1, 1}));
  EXPECT_TRUE(mentions(*model, "scale of node 0: has two channels; the first stands"));
  EXPECT_TRUE(mentions(*model, "a channel on \"visibility\""));
  EXPECT_TRUE(mentions(*model, "1 channels name no node"));
  EXPECT_TRUE(mentions(*model, "no morph targets"));
  b.json["animations"][0]["channels"][0]["sampler"] = 2;
  EXPECT_FALSE(b.read());
}

}  // namespace
}  // namespace sinew::test
