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
