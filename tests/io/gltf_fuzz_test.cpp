/// Damaged files: whatever is done to them, reading ends, and ends with a model or a reason. Worth most under
/// AddressSanitizer. The damage is the same in every run.

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <random>

#include "engine/model/character_mesh.h"
#include "tests/support/painted_gltf.h"

namespace sinew::test {
namespace {

using nlohmann::json;

constexpr int mutations = 300;

GltfBuilder skinned() {
  GltfBuilder b;
  auto primitive = b.triangle();
  primitive["attributes"]["JOINTS_0"] = b.integers<unsigned char>("VEC4", {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3});
  primitive["attributes"]["WEIGHTS_0"] = b.floats("VEC4", {.5, .5, 0, 0, .25, .25, .25, .25, 1, 0, 0, 0});
  primitive["indices"] = b.integers<unsigned short>("SCALAR", {0, 1, 2});
  b.draw(primitive, 4);
  b.json["skins"][0]["inverseBindMatrices"] = b.floats("MAT4", std::vector<double>(64, 1.0));
  return b;
}

GltfBuilder morphed() {
  GltfBuilder b;
  auto primitive = b.triangle();
  primitive["targets"] = {{{"POSITION", b.floats("VEC3", {0, 0, 1, 0, 0, 0, 0, 0, 0})}}};
  b.add("meshes", {{"primitives", {primitive}}, {"weights", {1}}, {"extras", {{"targetNames", {"smile"}}}}});
  b.add("nodes", {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1}}});
  b.add("nodes", {{"children", {0}}, {"rotation", {0, 0, 0, 1}}, {"scale", {1, 2, 3}}, {"translation", {0, 0, 1}}});
  b.add("scenes", {{"nodes", {1}}});
  b.json["scene"] = 0;
  return b;
}

GltfBuilder animated() {
  GltfBuilder b = skinned();
  const int input = b.floats("SCALAR", {0, 1}),
            output = b.integers<short>("VEC4", {0, 0, 0, 32767, 32767, 0, 0, 0}, true);
  b.add("animations", {{"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "rotation"}}}}}},
                       {"samplers", {{{"input", input}, {"output", output}, {"interpolation", "LINEAR"}}}}});
  return b;
}

GltfBuilder sparse() {
  GltfBuilder b;
  b.draw(b.triangle());
  const int indices = b.view<unsigned short>(std::vector<int>{0, 2}),
            values = b.view<float>(std::vector<double>{1, 2, 3, 4, 5, 6});
  b.json["accessors"][0]["sparse"] = {{"count", 2},
                                      {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                      {"values", {{"bufferView", values}}}};
  return b;
}

/// A material with all that a material can have, on vertices that carry all that they can carry for it.
GltfBuilder dressed() {
  GltfBuilder b;
  b.json["extensionsUsed"] = {"KHR_texture_transform", "KHR_materials_specular"};
  b.json["extensionsRequired"] = {"KHR_texture_transform"};
  b.add("images", {{"bufferView", b.view<unsigned char>(png_head())}, {"mimeType", "image/png"}});
  b.add("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
  b.add("textures", {{"sampler", 0}, {"source", 0}});
  json material = {
      {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 1}}, {"metallicFactor", 0.5}, {"roughnessFactor", 0.5}}},
      {"emissiveFactor", {0.5, 0.5, 0.5}},
      {"alphaMode", "MASK"},
      {"alphaCutoff", 0.5},
      {"doubleSided", true},
      {"extensions",
       {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}},
        {"KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 1, 2}}}}}}};
  for (const TexturePlace& place : texture_places)
    material[json::json_pointer(place.pointer)] = {
        {"index", 0},
        {"texCoord", 1},
        {"extensions",
         {{"KHR_texture_transform", {{"offset", {0, 1}}, {"scale", {2, 0.5}}, {"rotation", 1}, {"texCoord", 0}}}}}};
  material["normalTexture"]["scale"] = 0.5;
  material["occlusionTexture"]["strength"] = 0.5;
  material["emissiveTexture"]["extensions"]["KHR_texture_transform"]["texCoord"] = 1;
  b.add("materials", material);
  auto primitive = b.triangle();
  primitive["material"] = 0;
  json& attributes = primitive["attributes"];
  attributes["NORMAL"] = b.floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
  attributes["TANGENT"] =
      b.integers<short>("VEC4", {32767, 0, 0, 32767, 0, 32767, 0, 32767, 32767, 0, 0, -32767}, true);
  attributes["TEXCOORD_0"] = b.floats("VEC2", {0, 0, 1, 0, 0, 1});
  attributes["TEXCOORD_1"] = b.integers<unsigned short>("VEC2", {0, 0, 65535, 0, 0, 65535}, true);
  attributes["COLOR_0"] = b.integers<unsigned char>("VEC4", std::vector<double>(12, 128), true);
  b.draw(primitive);
  b.json["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"]["hips"]["node"] = 0;
  return b;
}

/// An older file's material, and a normal texture without tangents: they are generated.
GltfBuilder dressed_of_old() {
  GltfBuilder b = painted(
      {{{"normalTexture", {{"index", 1}}},
        {"extensions",
         {{"KHR_materials_unlit", json::object()},
          {"KHR_materials_pbrSpecularGlossiness",
           {{"diffuseFactor", {1, 1, 1, 1}}, {"diffuseTexture", {{"index", 0}}}, {"glossinessFactor", 0.5}}}}}}});
  auto primitive = b.triangle();
  primitive["material"] = 0;
  primitive["attributes"]["TEXCOORD_0"] = b.floats("VEC2", {0, 0, 1, 0, 0, 1});
  primitive["attributes"]["COLOR_0"] = b.floats("VEC3", std::vector<double>(9, 0.5));
  b.draw(primitive);
  return b;
}

bool within(double x, double low, double high) { return x >= low && x <= high; }

/// What the model promises of surfaces, however damaged the file was.
void expect_sound_surfaces(const Model& model, int mutation) {
  for (const Material& m : model.materials) {
    for (const double share :
         {m.base_colour.x, m.base_colour.w, m.metallic, m.roughness, m.occlusion_strength, m.specular})
      EXPECT_TRUE(within(share, 0, 1)) << "mutation " << mutation;
    for (const double number : {m.normal_scale, m.emissive.x, m.specular_colour.z, m.alpha_cutoff})
      EXPECT_TRUE(std::isfinite(number)) << "mutation " << mutation;
    for (const TexturePlace& place : texture_places) {
      const Texture& texture = m.*place.texture;
      EXPECT_TRUE(within(texture.image, -1, static_cast<double>(model.images.size()) - 1)) << "mutation " << mutation;
      EXPECT_TRUE(within(texture.coordinates, 0, 1)) << "mutation " << mutation;
    }
  }
  if (!check_drawn_vertices(model)) return;
  const CharacterMesh mesh = character_mesh(model);
  for (const Vec4& tangent : mesh.tangents) {
    EXPECT_NEAR(glm::length(Vec3(tangent)), 1.0, 1e-9) << "mutation " << mutation;
    EXPECT_EQ(std::abs(tangent.w), 1.0) << "mutation " << mutation;
  }
  for (const Vec4& colour : mesh.colours) EXPECT_TRUE(within(colour.x, 0, 1) && within(colour.w, 0, 1));
}

void expect_an_end(const std::string& content, int mutation) {
  const auto begin = std::chrono::steady_clock::now();
  const auto model = read_text(content);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10)) << "mutation " << mutation;
  if (model)
    expect_sound_surfaces(*model, mutation);
  else
    EXPECT_EQ(model.error().kind, ErrorKind::bad_input) << "mutation " << mutation;
}

using Random = std::mt19937;
std::size_t pick(Random& random, std::size_t below) { return random() % below; }

void damage_bytes(std::string& content, Random& random) {
  for (std::size_t n = 1 + pick(random, 4); n > 0 && !content.empty(); --n) {
    switch (pick(random, 4)) {
      case 0:
        content.erase(pick(random, content.size()), 1 + pick(random, 8));
        break;
      case 1:
        content.insert(pick(random, content.size()), 1, static_cast<char>(random()));
        break;
      case 2:
        content.resize(std::max<std::size_t>(1, pick(random, content.size())));
        break;
      default:
        content[pick(random, content.size())] = static_cast<char>(random());
    }
  }
}

/// Every value in the document.
void collect(json& value, std::vector<json*>& values) {
  values.push_back(&value);
  if (value.is_structured())
    for (json& part : value) collect(part, values);
}

void damage_json(json& document, Random& random) {
  static const std::vector<json> replacements = {-1,
                                                 0,
                                                 1,
                                                 2,
                                                 255,
                                                 65535,
                                                 4294967295u,
                                                 2147483647,
                                                 -2147483648LL,
                                                 18446744073709551615u,
                                                 1e300,
                                                 -1e300,
                                                 0.5,
                                                 true,
                                                 nullptr,
                                                 "",
                                                 "x",
                                                 "VEC3",
                                                 "MAT4",
                                                 "SCALAR",
                                                 json::array(),
                                                 json::object(),
                                                 {0},
                                                 {{"a", 1}},
                                                 5120,
                                                 5121,
                                                 5122,
                                                 5123,
                                                 5125,
                                                 5126};
  for (std::size_t n = 1 + pick(random, 3); n > 0; --n) {
    std::vector<json*> values;
    collect(document, values);
    json& value = *values[pick(random, values.size())];
    const std::size_t how = pick(random, 8);
    if (how == 0 && value.is_array() && !value.empty())
      value.push_back(json(value[0]));
    else if (how == 1 && value.is_object() && !value.empty())
      value.erase(value.begin());
    else if (!value.is_structured() || how == 2)
      value = replacements[pick(random, replacements.size())];
  }
}

void fuzz(const std::function<GltfBuilder()>& seed) {
  const GltfBuilder builder = seed();
  const auto whole = builder.read();
  ASSERT_TRUE(whole) << whole.error().message;
  Random random(20260);
  for (int i = 0; i < mutations; ++i) {
    std::string content = i % 2 == 0 ? builder.binary() : builder.text();
    damage_bytes(content, random);
    expect_an_end(content, i);
  }
  for (int i = 0; i < mutations; ++i) {
    GltfBuilder damaged = builder;
    damage_json(damaged.json, random);
    if (damaged.json.is_object()) expect_an_end(i % 2 == 0 ? damaged.binary() : damaged.text(), i);
  }
}

TEST(GltfFuzz, Skinned) { fuzz(skinned); }
TEST(GltfFuzz, Morphed) { fuzz(morphed); }
TEST(GltfFuzz, Animated) { fuzz(animated); }
TEST(GltfFuzz, Sparse) { fuzz(sparse); }
TEST(GltfFuzz, Dressed) { fuzz(dressed); }
TEST(GltfFuzz, DressedOfOld) { fuzz(dressed_of_old); }

}  // namespace
}  // namespace sinew::test
