#include "engine/io/gltf_material.h"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/painted_gltf.h"

namespace sinew::test {
namespace {

using nlohmann::json;

Material material_of(const json& material) { return read_material(painted({material})); }

TEST(GltfMaterial, DefaultsAreThoseOfGltf) {
  for (const json& bare :
       {json::object(), json{{"pbrMetallicRoughness", json::object()}},
        json{{"extensions",
              {{"KHR_materials_specular", json::object()}, {"KHR_materials_emissive_strength", json::object()}}}}}) {
    const Material m = material_of(bare);
    EXPECT_EQ(m.name, "");
    EXPECT_EQ(m.base_colour, Vec4(1.0));
    EXPECT_EQ(m.metallic, 1.0);
    EXPECT_EQ(m.roughness, 1.0);
    EXPECT_EQ(m.normal_scale, 1.0);
    EXPECT_EQ(m.occlusion_strength, 1.0);
    EXPECT_EQ(m.emissive, Vec3(0.0));
    EXPECT_EQ(m.specular, 1.0);
    EXPECT_EQ(m.specular_colour, Vec3(1.0));
    EXPECT_EQ(m.alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(m.alpha_cutoff, 0.5);
    EXPECT_FALSE(m.double_sided || m.unlit);
    for (const TexturePlace& place : texture_places) EXPECT_EQ(m.*place.texture, Texture()) << place.pointer;
  }
}

TEST(GltfMaterial, EveryPropertyIsRead) {
  const Material m =
      material_of({{"name", "skin"},
                   {"pbrMetallicRoughness",
                    {{"baseColorFactor", {0.5, 0.25, 1, 0.75}}, {"metallicFactor", 0.125}, {"roughnessFactor", 0.375}}},
                   {"normalTexture", {{"index", 0}, {"scale", -0.5}}},
                   {"occlusionTexture", {{"index", 1}, {"strength", 0.625}}},
                   {"emissiveFactor", {0.25, 0.5, 1}},
                   {"alphaMode", "MASK"},
                   {"alphaCutoff", 0.25},
                   {"doubleSided", true},
                   {"extensions",
                    {{"KHR_materials_unlit", json::object()},
                     {"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}},
                     {"KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {2, 0.5, 0}}}}}}});
  EXPECT_EQ(m.name, "skin");
  EXPECT_EQ(m.base_colour, Vec4(0.5, 0.25, 1, 0.75));
  EXPECT_EQ(m.metallic, 0.125);
  EXPECT_EQ(m.roughness, 0.375);
  EXPECT_EQ(m.normal_scale, -0.5) << "glTF bounds it on neither side";
  EXPECT_EQ(m.occlusion_strength, 0.625);
  EXPECT_EQ(m.emissive, Vec3(2, 4, 8)) << "times its strength";
  EXPECT_EQ(m.specular, 0.5);
  EXPECT_EQ(m.specular_colour, Vec3(2, 0.5, 0));
  EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(m.alpha_cutoff, 0.25);
  EXPECT_TRUE(m.double_sided && m.unlit);
}

TEST(GltfMaterial, AlphaModes) {
  EXPECT_EQ(material_of({{"alphaMode", "OPAQUE"}}).alpha_mode, AlphaMode::opaque);
  EXPECT_EQ(material_of({{"alphaMode", "BLEND"}}).alpha_mode, AlphaMode::blend);
  EXPECT_EQ(material_of({{"alphaMode", "MASK"}, {"alphaCutoff", 1.5}}).alpha_cutoff, 1.5) << "may hide everything";
}

TEST(GltfMaterial, EachTextureGoesToItsPlace) {
  json all = json::object();
  for (int i = 0; i < texture_count; ++i)
    all[json::json_pointer(texture_places[i].pointer)]["index"] = texture_count - 1 - i;
  GltfBuilder b = painted({all});
  b.add("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
  b.json["textures"][0]["sampler"] = 0;
  const Material m = read_material(b);
  for (int i = 0; i < texture_count; ++i) {
    const Texture& texture = m.*texture_places[i].texture;
    EXPECT_EQ(texture.image, texture_count - 1 - i) << texture_places[i].pointer;
    const bool sampled = i == texture_count - 1;
    EXPECT_EQ(texture.wrap_u, sampled ? Wrap::clamp : Wrap::repeat);
    EXPECT_EQ(texture.wrap_v, sampled ? Wrap::mirror : Wrap::repeat);
    EXPECT_EQ(texture.nearest_filter, sampled);
    EXPECT_FALSE(texture.transformed());
  }
}

TEST(GltfMaterial, EachTextureHasATransformOfItsOwn) {
  for (const TexturePlace& place : texture_places) {
    const Texture texture =
        material_of(
            holding(place.pointer,
                    {{"index", 2},
                     {"extensions",
                      {{"KHR_texture_transform", {{"offset", {0.5, 0}}, {"scale", {2, 1}}, {"rotation", 0.5}}}}}})).*
        place.texture;
    EXPECT_EQ(texture.image, 2) << place.pointer;
    EXPECT_EQ(texture.offset, Vec2(0.5, 0.0));
    EXPECT_EQ(texture.scale, Vec2(2.0, 1.0));
    EXPECT_EQ(texture.rotation, 0.5);
    EXPECT_TRUE(texture.transformed());
  }
}

TEST(GltfMaterial, TransformsScaleThenTurnCounterClockwiseThenMove) {
  Texture texture;
  texture.offset = {0.5, 0};
  texture.scale = {2, 1};
  texture.rotation = std::numbers::pi / 2;
  // A quarter turn counter-clockwise with v pointing down: u goes to -v, v to u.
  EXPECT_LT(glm::distance(texture.apply({1, 0}), Vec2(0.5, -2.0)), 1e-12);
  EXPECT_LT(glm::distance(texture.apply({0, 1}), Vec2(1.5, 0.0)), 1e-12);
  EXPECT_LT(glm::distance(texture.apply({0, 0}), Vec2(0.5, 0.0)), 1e-12);
}

TEST(GltfMaterial, ATextureNamesOneOfTwoSetsOfCoordinates) {
  for (const TexturePlace& one : texture_places)
    for (const TexturePlace& other : texture_places) {
      if (&one == &other) continue;
      json both = holding(one.pointer, {{"index", 0}, {"texCoord", 3}});
      both[json::json_pointer(other.pointer)] = {{"index", 1}, {"texCoord", 1}};
      const Material m = material_of(both);
      EXPECT_NE((m.*one.texture).coordinates, (m.*other.texture).coordinates) << one.pointer << " " << other.pointer;
      both[json::json_pointer(other.pointer)]["extensions"]["KHR_texture_transform"]["texCoord"] = 3;
      const Material overridden = material_of(both);
      EXPECT_EQ((overridden.*one.texture).coordinates, 0);
      EXPECT_EQ((overridden.*other.texture).coordinates, 0) << "the transform's number goes before the texture's";
    }
}

TEST(GltfMaterial, AThirdSetOfCoordinatesIsLeftOutWithAWord) {
  json three = json::object();
  for (int i = 0; i < 3; ++i) three[json::json_pointer(texture_places[i].pointer)] = {{"index", i}, {"texCoord", i}};
  expect_told(three, "materials/0/normalTexture: TEXCOORD_2 is a third set", [](const Material& m) {
    EXPECT_EQ(m.metallic_roughness_texture.image, 1);
    EXPECT_FALSE(m.normal_texture.there());
  });
}

TEST(GltfMaterial, SpecularGlossinessIsReadWhereThereIsNothingElse) {
  const json old = {{"diffuseFactor", {0.5, 0.25, 1, 0.75}},
                    {"diffuseTexture", {{"index", 3}, {"texCoord", 0}}},
                    {"glossinessFactor", 0.75}};
  const json extensions = {{"KHR_materials_pbrSpecularGlossiness", old}};
  const Material m = material_of({{"extensions", extensions}});
  EXPECT_EQ(m.base_colour, Vec4(0.5, 0.25, 1, 0.75));
  EXPECT_EQ(m.base_colour_texture.image, 3);
  EXPECT_EQ(m.metallic, 0.0);
  EXPECT_EQ(m.roughness, 0.25);
  const Material both = material_of({{"extensions", extensions}, {"pbrMetallicRoughness", {{"metallicFactor", 0.5}}}});
  EXPECT_EQ(both.base_colour, Vec4(1.0));
  EXPECT_EQ(both.metallic, 0.5);
}

}  // namespace
}  // namespace sinew::test
