#include "engine/io/vrm_write.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/body/figure.h"
#include "tests/support/glb.h"
#include "tests/support/rig_round_trip.h"

namespace sinew::test {
namespace {

TEST(VrmWrite, HasMapAndMetaAndIsReadBack) {
  const auto figure = build_figure(*figure_preset("skeleton"));
  ASSERT_TRUE(figure);
  VrmMeta meta;
  for (const char* word : {"authors=Ada", "authors=Grace", "name=Old", "name=Figure", "allowRedistribution=true",
                           "creditNotation=unnecessary"})
    ASSERT_TRUE(add_vrm_meta(meta, word)) << word;
  const auto bytes = vrm_glb(*figure, {{"hips", 0}, {"head", 5}}, meta);
  ASSERT_TRUE(bytes) << bytes.error().message;
  const nlohmann::json json = glb_json(*bytes);
  EXPECT_EQ(json.at("extensionsUsed"), nlohmann::json::array({"VRMC_vrm"}));
  const nlohmann::json& vrm = json.at("extensions").at("VRMC_vrm");
  EXPECT_EQ(vrm.at("specVersion"), "1.0");
  EXPECT_EQ(vrm.at("humanoid").at("humanBones").at("head").at("node"), 5);
  EXPECT_EQ(vrm.at("meta").at("name"), "Figure");
  EXPECT_EQ(vrm.at("meta").at("authors"), nlohmann::json::array({"Ada", "Grace"}));
  EXPECT_EQ(vrm.at("meta").at("allowRedistribution"), true);
  EXPECT_EQ(vrm.at("meta").at("licenseUrl"), "https://vrm.dev/licenses/1.0/");
  const auto model = read_back(*bytes);
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->vrm_bones, (std::map<std::string, int>{{"hips", 0}, {"head", 5}}));
}

TEST(VrmWrite, ExpressionsBindTheTargetsOfTheirNames) {
  auto figure = build_figure(*figure_preset("skeleton"));
  ASSERT_TRUE(figure);
  const std::size_t vertices = figure->meshes[0].primitives[0].positions.size();
  for (const char* name : {"browUp", "happy", "wink"})
    figure->meshes[0].primitives[0].morph_targets.push_back({name, std::vector<Vec3>(vertices, Vec3(0, 1e-3, 0)), {}});
  const std::vector<VrmExpression> wanted{{"happy", "block", "blend", "none"}, {"wink"}, {"sad"}};
  const auto bytes = vrm_glb(*figure, {{"hips", 0}}, {}, wanted);
  ASSERT_TRUE(bytes) << bytes.error().message;
  const nlohmann::json json = glb_json(*bytes);
  const nlohmann::json& expressions = json.at("extensions").at("VRMC_vrm").at("expressions");
  const nlohmann::json& happy = expressions.at("preset").at("happy");
  ASSERT_EQ(happy.at("morphTargetBinds").size(), 1u);
  const nlohmann::json& bind = happy.at("morphTargetBinds")[0];
  EXPECT_EQ(bind.at("index"), 1);
  EXPECT_EQ(bind.at("weight"), 1.0);
  const nlohmann::json& node = json.at("nodes").at(bind.at("node").get<std::size_t>());
  EXPECT_EQ(json.at("meshes").at(node.at("mesh").get<std::size_t>()).at("extras").at("targetNames")[1], "happy");
  EXPECT_EQ(happy.at("overrideMouth"), "block");
  EXPECT_EQ(happy.at("overrideBlink"), "blend");
  EXPECT_EQ(happy.at("overrideLookAt"), "none");
  // What VRM has no name for is custom; what the mesh has no target for is left out.
  EXPECT_TRUE(expressions.at("custom").contains("wink"));
  EXPECT_FALSE(expressions.at("preset").contains("sad"));
}

TEST(VrmWrite, OddMetaIsRefused) {
  VrmMeta meta;
  for (const char* word : {"nme=x", "name", "=x", "name=", "avatarPermission=all", "allowRedistribution=yes"}) {
    const auto result = add_vrm_meta(meta, word);
    ASSERT_FALSE(result) << word;
    EXPECT_EQ(result.error().kind, ErrorKind::usage);
  }
  EXPECT_TRUE(meta.values.empty());
}

}  // namespace
}  // namespace sinew::test
