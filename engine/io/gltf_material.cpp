#include "engine/io/gltf_material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/io/gltf_schema.h"

namespace sinew::gltf {
namespace {

using nlohmann::json;

Wrap wrap_of(int mode) {
  if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp;
  return mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirror : Wrap::repeat;
}

/// Floats hold these numbers and their products with each other.
constexpr double greatest_number = 1e15;
/// Of KHR_materials_emissive_strength, which knows no bound: a picture's white is 1.
constexpr double greatest_strength = 1e6;
/// Of a specular colour, which knows no bound either: 4 % of it is all the light there is.
constexpr double greatest_specular = 25.0;
/// One more than the highest n of a TEXCOORD_n that a texture may ask for.
constexpr std::size_t sets_to_choose_from = std::numeric_limits<int>::max();

constexpr const char* specular_glossiness = "KHR_materials_pbrSpecularGlossiness";

/// A reference written in an extension, which conform() does not see; -1 where it is none.
int index_at(const json* value, std::size_t size) {
  if (value == nullptr || !value->is_number()) return -1;
  const double x = value->get<double>();
  return x >= 0 && x < static_cast<double>(size) && x == std::floor(x) ? static_cast<int>(x) : -1;
}

/// Reads one material, property by property.
class MaterialReader {
 public:
  MaterialReader(Document& document, std::size_t index)
      : document_(document),
        from_(document.gltf.materials[index]),
        source_(document.source["materials"][index]),
        place_(fmt::format("materials/{}", index)) {}

  void run() {
    material.name = from_.name;
    material.double_sided = from_.doubleSided;
    material.alpha_cutoff = from_.alphaCutoff;
    if (from_.alphaMode == "MASK") material.alpha_mode = AlphaMode::mask;
    if (from_.alphaMode == "BLEND") material.alpha_mode = AlphaMode::blend;
    material.unlit = extension("KHR_materials_unlit") != nullptr;
    if (find(source_, {"pbrMetallicRoughness"}) == nullptr && extension(specular_glossiness) != nullptr)
      read_specular_glossiness(*extension(specular_glossiness));
    else
      read_metallic_roughness();
    read_relief();
    read_emission();
    read_specular();
  }

  Material material;
  CoordinateSets sets{0, -1};

 private:
  void read_metallic_roughness() {
    const tinygltf::PbrMetallicRoughness& from = from_.pbrMetallicRoughness;
    const auto& factor = from.baseColorFactor;
    material.base_colour =
        clamped_colour({factor[0], factor[1], factor[2], factor[3]}, place_ + "/pbrMetallicRoughness/baseColorFactor");
    material.metallic = clamped(from.metallicFactor, place_ + "/pbrMetallicRoughness/metallicFactor");
    material.roughness = clamped(from.roughnessFactor, place_ + "/pbrMetallicRoughness/roughnessFactor");
    material.base_colour_texture = texture({"pbrMetallicRoughness", "baseColorTexture"});
    material.metallic_roughness_texture = texture({"pbrMetallicRoughness", "metallicRoughnessTexture"});
  }

  /// KHR_materials_pbrSpecularGlossiness, archived but met in older files: its diffuse colour is our base colour, what
  /// is not glossy is rough. The colour that it mirrors is not read: most such files give it by a texture.
  void read_specular_glossiness(const json& from) {
    const std::string place = extension_place(specular_glossiness);
    material.metallic = 0.0;
    std::array<double, 4> factor{1.0, 1.0, 1.0, 1.0};
    numbers(from, place, "diffuseFactor", "four numbers", factor);
    material.base_colour = clamped_colour(factor, place + "/diffuseFactor");
    material.base_colour_texture = texture({"extensions", specular_glossiness, "diffuseTexture"});
    material.roughness = 1.0 - clamped(number(from, place, "glossinessFactor", 1.0), place + "/glossinessFactor");
  }

  void read_relief() {
    material.normal_texture = texture({"normalTexture"});
    material.normal_scale = from_.normalTexture.scale;
    material.occlusion_texture = texture({"occlusionTexture"});
    material.occlusion_strength = clamped(from_.occlusionTexture.strength, place_ + "/occlusionTexture/strength");
  }

  void read_emission() {
    if (from_.emissiveFactor.size() == 3)
      for (int i = 0; i < 3; ++i) material.emissive[i] = clamped(from_.emissiveFactor[i], place_ + "/emissiveFactor");
    const char* name = "KHR_materials_emissive_strength";
    if (const json* from = extension(name))
      material.emissive *= clamped(number(*from, extension_place(name), "emissiveStrength", 1.0),
                                   extension_place(name) + "/emissiveStrength", greatest_strength);
    material.emissive_texture = texture({"emissiveTexture"});
  }

  void read_specular() {
    const char* name = "KHR_materials_specular";
    const json* from = extension(name);
    if (from == nullptr) return;
    const std::string place = extension_place(name);
    material.specular = clamped(number(*from, place, "specularFactor", 1.0), place + "/specularFactor");
    std::array<double, 3> colour{1.0, 1.0, 1.0};
    numbers(*from, place, "specularColorFactor", "three numbers", colour);
    for (int i = 0; i < 3; ++i)
      material.specular_colour[i] = clamped(colour[i], place + "/specularColorFactor", greatest_specular);
  }

  /// The texture that is described at a chain of keys of the material, or none. conform() has checked what lies outside
  /// extensions only.
  Texture texture(std::initializer_list<const char*> keys) {
    const json* info = find(source_, keys);
    if (info == nullptr || !info->is_object()) return {};
    const std::string place = fmt::format("{}/{}", place_, fmt::join(keys, "/"));
    const int index = index_at(find(*info, {"index"}), document_.gltf.textures.size());
    if (index < 0) {
      document_.problem("{}: names no texture of the file; drawn without it", place);
      return {};
    }
    const tinygltf::Texture& from = document_.gltf.textures[static_cast<std::size_t>(index)];
    Texture texture;
    if (from.source < 0) document_.problem("{}: textures/{} has no PNG or JPEG image; drawn without it", place, index);
    texture.image = from.source;
    read_sampler(from, texture);
    int set = std::max(index_at(find(*info, {"texCoord"}), sets_to_choose_from), 0);
    read_transform(*info, place, texture, set);
    choose_coordinates(set, place, texture);
    return texture;
  }

  void read_sampler(const tinygltf::Texture& from, Texture& texture) const {
    if (from.sampler < 0) return;
    const tinygltf::Sampler& sampler = document_.gltf.samplers[static_cast<std::size_t>(from.sampler)];
    texture.wrap_u = wrap_of(sampler.wrapS);
    texture.wrap_v = wrap_of(sampler.wrapT);
    texture.nearest_filter = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  }

  void read_transform(const json& info, const std::string& place, Texture& texture, int& set) {
    const char* name = "KHR_texture_transform";
    const json* transform = extension(info, name, place);
    if (transform == nullptr) return;
    const std::string at = fmt::format("{}/extensions/{}", place, name);
    const auto pair = [&](const char* key, Vec2& to) {
      std::array<double, 2> two{to.x, to.y};
      numbers(*transform, at, key, "two numbers", two);
      to = {two[0], two[1]};
    };
    pair("offset", texture.offset);
    pair("scale", texture.scale);
    texture.rotation = number(*transform, at, "rotation", 0.0);
    const json* other = find(*transform, {"texCoord"});
    if (other == nullptr) return;
    if (const int chosen = index_at(other, sets_to_choose_from); chosen >= 0)
      set = chosen;
    else
      document_.problem("{}/texCoord: must be a whole number from 0 on; ignored", at);
  }

  void choose_coordinates(int set, const std::string& place, Texture& texture) {
    if (!texture.there()) return;
    if (!any_texture_) sets[0] = set;
    any_texture_ = true;
    if (set == sets[0]) return;
    if (sets[1] < 0) sets[1] = set;
    texture.coordinates = 1;
    if (set == sets[1]) return;
    document_.problem("{}: TEXCOORD_{} is a third set of texture coordinates, two is the most; drawn without it", place,
                      set);
    texture = {};
  }

  /// `property` with its place in the file.
  Vec4 clamped_colour(const std::array<double, 4>& c, const std::string& property) {
    const Vec4 colour(c[0], c[1], c[2], c[3]);
    const Vec4 clamped = glm::clamp(colour, 0.0, 1.0);
    if (colour != clamped) document_.problem("{}: a colour outside 0 to 1; clamped", property);
    return clamped;
  }

  double clamped(double value, const std::string& property, double high = 1.0) {
    if (value < 0.0 || value > high)
      document_.problem("{}: {:.4g} lies outside 0 to {:.6g}; clamped", property, value, high);
    return std::clamp(value, 0.0, high);
  }

  std::string extension_place(const char* name) const { return fmt::format("{}/extensions/{}", place_, name); }
  const json* extension(const char* name) { return extension(source_, name, place_); }

  /// What an extension says of a part of the material, `place` being the part's; nullptr where it says nothing.
  const json* extension(const json& part, const char* name, const std::string& place) {
    const json* value = find(part, {"extensions", name});
    if (value == nullptr || value->is_object()) return value;
    document_.problem("{}/extensions/{}: must be an object; ignored", place, name);
    return nullptr;
  }

  /// A number of an extension, which conform() does not see.
  double number(const json& from, const std::string& place, const char* key, double otherwise) {
    const json* value = find(from, {key});
    if (value == nullptr) return otherwise;
    if (value->is_number() && std::abs(value->get<double>()) < greatest_number) return value->get<double>();
    document_.problem("{}/{}: must be a number; ignored", place, key);
    return otherwise;
  }

  /// Likewise a list of numbers; `to` stays where there is none.
  template <std::size_t N>
  void numbers(const json& from, const std::string& place, const char* key, const char* words,
               std::array<double, N>& to) {
    const json* value = find(from, {key});
    if (value == nullptr) return;
    const bool good = value->is_array() && value->size() == N && std::ranges::all_of(*value, [](const json& x) {
                        return x.is_number() && std::abs(x.template get<double>()) < greatest_number;
                      });
    if (!good) return document_.problem("{}/{}: must be {}; ignored", place, key, words);
    for (std::size_t i = 0; i < N; ++i) to[i] = (*value)[i].template get<double>();
  }

  Document& document_;
  const tinygltf::Material& from_;
  const json& source_;
  std::string place_;
  bool any_texture_ = false;
};

}  // namespace

Materials read_materials(Document& document) {
  Materials read;
  for (std::size_t i = 0; i < document.gltf.materials.size(); ++i) {
    MaterialReader reader(document, i);
    reader.run();
    read.materials.push_back(std::move(reader.material));
    read.sets.push_back(reader.sets);
  }
  return read;
}

}  // namespace sinew::gltf
