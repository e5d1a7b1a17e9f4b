/// Materials with faults: what is refused, what is mended or passed over with a word, and where that is said to be.

#include <gtest/gtest.h>

#include "tests/support/painted_gltf.h"

namespace sinew::test {
namespace {

using nlohmann::json;

TEST(GltfMaterialFaults, NumbersOutsideTheirRangeAreClampedWithAWord) {
  struct Case {
    const char* pointer;
    json value;
    double Material::*property;
    double clamped;
  };
  const Case cases[] = {{"pbrMetallicRoughness/metallicFactor", 1.5, &Material::metallic, 1.0},
                        {"pbrMetallicRoughness/roughnessFactor", -0.5, &Material::roughness, 0.0},
                        {"extensions/KHR_materials_specular/specularFactor", 2, &Material::specular, 1.0}};
  for (const auto& [pointer, value, property, clamped] : cases)
    expect_told(holding(fmt::format("/{}", pointer).c_str(), value),
                fmt::format("materials/0/{}: {} lies outside 0 to 1; clamped", pointer, value.dump()).c_str(),
                [&, p = property, c = clamped](const Material& m) { EXPECT_EQ(m.*p, c); });
  expect_told({{"occlusionTexture", {{"index", 0}, {"strength", 3}}}}, "materials/0/occlusionTexture/strength: 3 lies",
              [](const Material& m) { EXPECT_EQ(m.occlusion_strength, 1.0); });
  expect_told({{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 2, 0, 1}}}}},
              "materials/0/pbrMetallicRoughness/baseColorFactor: a colour outside 0 to 1",
              [](const Material& m) { EXPECT_EQ(m.base_colour, Vec4(0.5, 1, 0, 1)); });
  expect_told({{"emissiveFactor", {0, 1.25, 0}}}, "materials/0/emissiveFactor: 1.25 lies outside 0 to 1",
              [](const Material& m) { EXPECT_EQ(m.emissive, Vec3(0, 1, 0)); });
  expect_told({{"emissiveFactor", {1, 1, 1}},
               {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", -2}}}}}},
              "materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength: -2 lies outside",
              [](const Material& m) { EXPECT_EQ(m.emissive, Vec3(0.0)); });
  expect_told(holding("/extensions/KHR_materials_specular/specularColorFactor", {-1, 0, 0}),
              "materials/0/extensions/KHR_materials_specular/specularColorFactor: -1 lies outside 0 to 25",
              [](const Material& m) { EXPECT_EQ(m.specular_colour, Vec3(0.0)); });
}

TEST(GltfMaterialFaults, WrongTypesAndBadReferencesAreRefusedAtTheirPlace) {
  struct Case {
    const char* pointer;
    json value;
    const char* reason;
  };
  const Case cases[] = {
      {"name", 1, "must be a text, found 1"},
      {"pbrMetallicRoughness", 1, "must be an object, found 1"},
      {"pbrMetallicRoughness/metallicFactor", "all", "must be a number, found \"all\""},
      {"pbrMetallicRoughness/roughnessFactor", true, "must be a number, found true"},
      {"pbrMetallicRoughness/baseColorFactor", {1, 1, 1}, "has 3 items; 4 are expected"},
      {"pbrMetallicRoughness/baseColorFactor", {1, 1, 1, "x"}, "/3: must be a number, found \"x\""},
      {"pbrMetallicRoughness/metallicFactor", 1e300, "must be a number from"},
      {"emissiveFactor", {1, 1, 1, 1}, "has 4 items; 3 are expected"},
      {"emissiveFactor", 1, "must be a list, found 1"},
      {"alphaMode", "CUTOUT", "must be one of OPAQUE, MASK, BLEND, found \"CUTOUT\""},
      {"alphaCutoff", -0.5, "must be a number from 0"},
      {"doubleSided", 1, "must be true or false, found 1"},
      {"normalTexture", json::object(), "/index: missing"},
      {"normalTexture", {{"index", 0}, {"scale", "x"}}, "/scale: must be a number, found \"x\""},
      {"occlusionTexture", {{"index", 0}, {"strength", true}}, "/strength: must be a number, found true"}};
  for (const auto& [pointer, value, reason] : cases)
    expect_refused(painted({holding(fmt::format("/{}", pointer).c_str(), value)}),
                   fmt::format("materials/0/{}{}{}", pointer, reason[0] == '/' ? "" : ": ", reason));
  for (const TexturePlace& place : texture_places) {
    const std::string at = fmt::format("materials/0{}", place.pointer);
    for (const json& index : {json(5), json(-1), json(0.5), json("0")})
      expect_refused(painted({holding(place.pointer, {{"index", index}})}),
                     fmt::format("{}/index: refers to textures {}, but there are 5", at, index.dump()));
    expect_refused(painted({holding(place.pointer, {{"texCoord", 0}})}), at + "/index: missing");
    expect_refused(painted({holding(place.pointer, {{"index", 0}, {"texCoord", -1}})}),
                   at + "/texCoord: must be a whole number");
  }
  GltfBuilder b = painted({});
  b.json["textures"][1]["source"] = 5;
  expect_refused(b, "textures/1/source: refers to images 5, but there are 5");
  b.json["textures"][1] = {{"sampler", 0}};
  expect_refused(b, "textures/1/sampler: refers to samplers 0, but there are 0");
  b.json["samplers"] = {{{"wrapS", 1}}};
  expect_refused(b, "samplers/0/wrapS: must be one of 33071, 33648, 10497, found 1");
}

/// What an extension says does not keep a character from being read.
TEST(GltfMaterialFaults, FaultsInExtensionsAreToldAtTheirPlaceAndPassedOver) {
  struct Case {
    const char* pointer;
    json value;
    const char* reason;
  };
  const Case cases[] = {
      {"KHR_materials_unlit", 1, "must be an object; ignored"},
      {"KHR_materials_specular", json::array(), "must be an object; ignored"},
      {"KHR_materials_specular/specularFactor", "x", "must be a number; ignored"},
      {"KHR_materials_specular/specularColorFactor", {1, 1}, "must be three numbers; ignored"},
      {"KHR_materials_specular/specularColorFactor", {1, 1, 1e300}, "must be three numbers; ignored"},
      {"KHR_materials_emissive_strength/emissiveStrength", nullptr, "must be a number; ignored"},
      {"KHR_materials_pbrSpecularGlossiness/diffuseFactor", {1, 1, 1, "x"}, "must be four numbers; ignored"},
      {"KHR_materials_pbrSpecularGlossiness/glossinessFactor", {1}, "must be a number; ignored"},
      {"KHR_materials_pbrSpecularGlossiness/diffuseTexture", {{"index", 5}}, "names no texture of the file"}};
  for (const auto& [pointer, value, reason] : cases)
    expect_told(holding(fmt::format("/extensions/{}", pointer).c_str(), value),
                fmt::format("materials/0/extensions/{}: {}", pointer, reason).c_str(), [](const Material& m) {
                  EXPECT_FALSE(m.unlit);
                  EXPECT_EQ(m.specular, 1.0);
                  EXPECT_EQ(m.specular_colour, Vec3(1.0));
                  EXPECT_EQ(m.base_colour, Vec4(1.0));
                });
  const Case transforms[] = {{"", 3, ": must be an object"},
                             {"/offset", {1}, "/offset: must be two numbers"},
                             {"/scale", 2, "/scale: must be two numbers"},
                             {"/rotation", "x", "/rotation: must be a number"},
                             {"/texCoord", -1, "/texCoord: must be a whole number from 0 on"}};
  for (const auto& [pointer, value, reason] : transforms) {
    json material = {{"normalTexture", {{"index", 0}}}};
    material[json::json_pointer(fmt::format("/normalTexture/extensions/KHR_texture_transform{}", pointer))] = value;
    expect_told(material, fmt::format("materials/0/normalTexture/extensions/KHR_texture_transform{}", reason).c_str(),
                [](const Material& m) {
                  EXPECT_EQ(m.normal_texture.image, 0);
                  EXPECT_FALSE(m.normal_texture.transformed());
                });
  }
}

TEST(GltfMaterialFaults, ATextureWithoutAPictureIsNoneWithAWord) {
  GltfBuilder b = painted({holding("/normalTexture/index", 1)});
  b.json["textures"][1].erase("source");
  const auto model = b.read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_FALSE(model->materials[0].normal_texture.there());
  EXPECT_TRUE(mentions(*model, "materials/0/normalTexture: textures/1 has no PNG or JPEG image"));
}

TEST(GltfMaterialFaults, ExtensionsThatMustBeKnownAreKnown) {
  GltfBuilder b = painted({json::object()});
  b.json["extensionsRequired"] = {"KHR_texture_transform",           "KHR_materials_unlit",
                                  "KHR_materials_emissive_strength", "KHR_materials_specular",
                                  "KHR_mesh_quantization",           "KHR_materials_pbrSpecularGlossiness"};
  b.json["extensionsUsed"] = b.json["extensionsRequired"];
  EXPECT_EQ(read_material(b).base_colour, Vec4(1.0));
  for (const char* name : {"KHR_materials_transmission", "KHR_texture_basisu", "EXT_texture_webp", ""}) {
    b.json["extensionsRequired"] = {"KHR_materials_unlit", name};
    expect_refused(b, fmt::format("extensionsRequired: the file needs the extension {}, which is not supported", name));
  }
}

}  // namespace
}  // namespace sinew::test
