#pragma once
/// glTF files with materials, for tests: pictures and textures are there, a material is added.

#include <functional>

#include "tests/support/gltf_builder.h"

namespace sinew::test {

/// A picture's first bytes: enough where nothing decodes it.
inline std::string png_head() { return "\x89PNG\r\n\x1a\n"; }

/// A place of a texture: where the file has it, and where the model does.
struct TexturePlace {
  const char* pointer;
  Texture Material::*texture;
};

inline const TexturePlace texture_places[] = {
    {"/pbrMetallicRoughness/baseColorTexture", &Material::base_colour_texture},
    {"/pbrMetallicRoughness/metallicRoughnessTexture", &Material::metallic_roughness_texture},
    {"/normalTexture", &Material::normal_texture},
    {"/occlusionTexture", &Material::occlusion_texture},
    {"/emissiveTexture", &Material::emissive_texture}};
constexpr int texture_count = 5;

/// A file with five pictures, a texture of each, and these materials.
inline GltfBuilder painted(const std::vector<nlohmann::json>& materials) {
  GltfBuilder b;
  for (int i = 0; i < texture_count; ++i) {
    b.add("images", {{"uri", "data:image/png;base64," + GltfBuilder::base64(png_head())}});
    b.add("textures", {{"source", i}});
  }
  for (const nlohmann::json& material : materials) b.add("materials", material);
  return b;
}

/// An object with a value at the end of a chain of keys.
inline nlohmann::json holding(const char* pointer, const nlohmann::json& value) {
  nlohmann::json object = nlohmann::json::object();
  object[nlohmann::json::json_pointer(pointer)] = value;
  return object;
}

/// The first material of a file that is read without a word; a default one and a failure where there is more to say.
inline Material read_material(const GltfBuilder& b) {
  const auto model = b.read();
  EXPECT_TRUE(model) << model.error().message;
  if (!model) return {};
  EXPECT_TRUE(model->problems.empty()) << model->problems.front();
  return model->materials.at(0);
}

/// A file that is read all the same, the first material given and the words that say what was done about it.
inline void expect_told(const nlohmann::json& material, const char* words,
                        const std::function<void(const Material&)>& check = {}) {
  const auto model = painted({material}).read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->problems.size(), 1u) << words;
  EXPECT_TRUE(mentions(*model, words)) << (model->problems.empty() ? "no word" : model->problems.front());
  if (check) check(model->materials.at(0));
}

}  // namespace sinew::test
