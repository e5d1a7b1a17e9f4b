/// Materials, textures and what vertices carry for them, written and read back.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/glb.h"
#include "tests/support/rig_round_trip.h"
#include "tests/support/small_rig.h"

namespace sinew::test {
namespace {

using nlohmann::json;

json json_of(const Model& model) {
  const auto file = rig_glb(model);
  EXPECT_TRUE(file) << file.error().message;
  return file ? glb_json(*file) : json{};
}

TEST(RigGlbMaterials, EveryPropertyAndTextureComesBack) {
  const Model model = dressed_meshes(), back = written_and_read(model);
  ASSERT_EQ(back.materials.size(), model.materials.size());
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    SCOPED_TRACE(model.materials[i].name);
    expect_same_material(model.materials[i], back.materials[i]);
  }
  ASSERT_EQ(back.images.size(), model.images.size());
  for (std::size_t i = 0; i < model.images.size(); ++i) {
    EXPECT_EQ(back.images[i].name, model.images[i].name);
    EXPECT_EQ(back.images[i].bytes, model.images[i].bytes);
  }
}

TEST(RigGlbMaterials, WhatVerticesCarryComesBack) {
  const Model model = dressed_meshes(), back = written_and_read(model);
  ASSERT_EQ(back.meshes.size(), model.meshes.size());
  for (std::size_t m = 0; m < model.meshes.size(); ++m) {
    const Primitive &a = model.meshes[m].primitives[0], &b = back.meshes[m].primitives[0];
    EXPECT_EQ(a.tangents, b.tangents);
    EXPECT_EQ(a.texture_coordinates, b.texture_coordinates);
    EXPECT_EQ(a.second_texture_coordinates, b.second_texture_coordinates);
    EXPECT_EQ(a.colours, b.colours);
  }
  EXPECT_FALSE(back.meshes[dressed_mesh].primitives[0].tangents.empty());
  EXPECT_FALSE(back.meshes[dressed_mesh].primitives[0].colours.empty());
}

TEST(RigGlbMaterials, ExtensionsAreNamedWhereTheyAreUsedOnly) {
  Model model = dressed_meshes();
  EXPECT_EQ(json_of(model)["extensionsUsed"],
            json({"KHR_materials_emissive_strength", "KHR_materials_specular", "KHR_texture_transform"}));
  EXPECT_FALSE(json_of(model).contains("extensionsRequired")) << "others draw it without";
  model.materials = {Material{}, Material{}};
  model.materials[1].unlit = true;
  const json written = json_of(model);
  EXPECT_EQ(written["extensionsUsed"], json::array({"KHR_materials_unlit"}));
  EXPECT_EQ(written["materials"][1]["extensions"], json({{"KHR_materials_unlit", json::object()}}));
}

TEST(RigGlbMaterials, DefaultsAreNotWritten) {
  Model model = two_meshes_on_one_skin();
  model.materials = {Material{}};
  model.materials[0].metallic = 0.25;
  EXPECT_EQ(json_of(model)["materials"],
            json::array(
                {{{"pbrMetallicRoughness",
                   {{"baseColorFactor", {1.0, 1.0, 1.0, 1.0}}, {"metallicFactor", 0.25}, {"roughnessFactor", 0.7}}}}}));
}

TEST(RigGlbMaterials, ATextureThatManyUseIsWrittenOnce) {
  Model model = dressed_meshes();
  for (Material& material : model.materials)
    for (const auto member : texture_members) material.*member = model.materials[1].normal_texture;
  model.materials[0].base_colour_texture.offset = {0.5, 0.5};
  model.materials[0].normal_texture.wrap_u = Wrap::clamp;
  const json written = json_of(model);
  EXPECT_EQ(written["images"].size(), 1u);
  EXPECT_EQ(written["textures"].size(), 2u) << "one a sampler; where it lies is not the texture's";
  EXPECT_EQ(written["samplers"].size(), 2u);
}

TEST(RigGlbMaterials, ASecondSetOfCoordinatesBringsAFirst) {
  Model model = dressed_meshes();
  Primitive& primitive = model.meshes[dressed_mesh].primitives[0];
  primitive.texture_coordinates.clear();
  const Primitive back = written_and_read(model).meshes[dressed_mesh].primitives[0];
  EXPECT_EQ(back.texture_coordinates, std::vector<Vec2>(primitive.positions.size(), Vec2(0.0)));
  EXPECT_EQ(back.second_texture_coordinates, primitive.second_texture_coordinates);
  model.meshes[dressed_mesh].primitives[0].second_texture_coordinates.clear();
  const Primitive bare = written_and_read(model).meshes[dressed_mesh].primitives[0];
  EXPECT_EQ(bare.second_texture_coordinates, std::vector<Vec2>(primitive.positions.size(), Vec2(0.0)))
      << "a texture asks for it";
}

TEST(RigGlbMaterials, NumbersOutsideGltfsRangesAreClamped) {
  Model model = two_meshes_on_one_skin();
  Material& material = model.materials[0];
  material.base_colour = {2, -1, 0.5, 1};
  material.metallic = -1;
  material.roughness = 3;
  material.occlusion_texture = material.base_colour_texture;
  material.occlusion_strength = 4;
  material.emissive = {-1, 0.5, 0};
  material.specular = 2;
  material.specular_colour = {-1, 3, 0};
  material.alpha_cutoff = -1;
  const Material back = written_and_read(model).materials.at(0);
  EXPECT_EQ(back.base_colour, Vec4(1, 0, 0.5, 1));
  EXPECT_EQ(back.metallic, 0.0);
  EXPECT_EQ(back.roughness, 1.0);
  EXPECT_EQ(back.occlusion_strength, 1.0);
  EXPECT_EQ(back.emissive, Vec3(0, 0.5, 0));
  EXPECT_EQ(back.specular, 1.0);
  EXPECT_EQ(back.specular_colour, Vec3(0, 3, 0));
  EXPECT_EQ(back.alpha_cutoff, 0.0);
}

}  // namespace
}  // namespace sinew::test
