#include <algorithm>
#include <array>
#include <initializer_list>
#include <set>
#include <tuple>

#include "engine/io/gltf_write_parts.h"

namespace sinew {
namespace {

constexpr int gl_nearest = 9728, gl_linear = 9729, gl_linear_mipmap_linear = 9987;

int wrap_code(Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return 10497;
    case Wrap::clamp:
      return 33071;
    case Wrap::mirror:
      return 33648;
  }
  return 10497;
}

bool starts_with(std::span<const unsigned char> bytes, std::initializer_list<unsigned char> head) {
  return bytes.size() >= head.size() && std::equal(head.begin(), head.end(), bytes.begin());
}

/// What the bytes are, by their first ones, or nothing where glTF has no place for them.
const char* mime_type(std::span<const unsigned char> bytes) {
  if (starts_with(bytes, {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'})) return "image/png";
  if (starts_with(bytes, {0xFF, 0xD8, 0xFF})) return "image/jpeg";
  return nullptr;
}

/// Writes materials and, each once, the textures, samplers and pictures that they use.
class MaterialWriter {
 public:
  MaterialWriter(const Model& model, GlbBuilder& glb) : model_(model), glb_(glb) {}

  void run() {
    Json materials = Json::array();
    for (const Material& material : model_.materials) materials.push_back(written(material));
    set_unless_empty(glb_.json, "materials", std::move(materials));
    set_unless_empty(glb_.json, "textures", std::move(textures_));
    set_unless_empty(glb_.json, "samplers", std::move(samplers_));
    set_unless_empty(glb_.json, "images", std::move(images_));
    for (const std::string& name : extensions_) glb_.json["extensionsUsed"].push_back(name);
  }

 private:
  using Sampler = std::tuple<Wrap, Wrap, bool>;

  Json written(const Material& material) {
    Json surface;
    std::array<double, 4> colour;
    for (int i = 0; i < 4; ++i) colour[i] = std::clamp(material.base_colour[i], 0.0, 1.0);
    surface["baseColorFactor"] = colour;
    set_texture(surface, "baseColorTexture", material.base_colour_texture);
    // glTF's default for both is 1: metal, which most viewers show as a dark mirror.
    surface["metallicFactor"] = std::clamp(material.metallic, 0.0, 1.0);
    surface["roughnessFactor"] = std::clamp(material.roughness, 0.0, 1.0);
    set_texture(surface, "metallicRoughnessTexture", material.metallic_roughness_texture);

    Json out = Json::object();
    if (!material.name.empty()) out["name"] = material.name;
    out["pbrMetallicRoughness"] = std::move(surface);
    set_texture(out, "normalTexture", material.normal_texture, "scale", material.normal_scale);
    set_texture(out, "occlusionTexture", material.occlusion_texture, "strength",
                std::clamp(material.occlusion_strength, 0.0, 1.0));
    set_texture(out, "emissiveTexture", material.emissive_texture);
    add_emission(out, material);
    add_specular(out, material);
    if (material.unlit) add_extension(out, "KHR_materials_unlit", Json::object());
    if (material.alpha_mode == AlphaMode::blend) out["alphaMode"] = "BLEND";
    if (material.alpha_mode == AlphaMode::mask) {
      out["alphaMode"] = "MASK";
      out["alphaCutoff"] = std::max(material.alpha_cutoff, 0.0);
    }
    if (material.double_sided) out["doubleSided"] = true;
    return out;
  }

  void add_extension(Json& object, const char* name, Json value) {
    object["extensions"][name] = std::move(value);
    extensions_.insert(name);
  }

  void add_emission(Json& out, const Material& material) {
    const double strongest = std::max({material.emissive.x, material.emissive.y, material.emissive.z});
    if (!(strongest > 0.0)) return;
    const double strength = std::max(strongest, 1.0);
    const Vec3 factor = glm::clamp(material.emissive / strength, 0.0, 1.0);
    out["emissiveFactor"] = {factor.x, factor.y, factor.z};
    if (strength > 1.0) add_extension(out, "KHR_materials_emissive_strength", {{"emissiveStrength", strength}});
  }

  void add_specular(Json& out, const Material& material) {
    Json specular = Json::object();
    if (const double factor = std::clamp(material.specular, 0.0, 1.0); factor != 1.0)
      specular["specularFactor"] = factor;
    const Vec3 colour = glm::max(material.specular_colour, 0.0);
    if (colour != Vec3(1.0)) specular["specularColorFactor"] = {colour.x, colour.y, colour.z};
    if (!specular.empty()) add_extension(out, "KHR_materials_specular", std::move(specular));
  }

  /// Describes a texture at a key, with a factor of its own where that is not 1; nothing where there is no picture.
  void set_texture(Json& object, const char* key, const Texture& texture, const char* factor_key = nullptr,
                   double factor = 1.0) {
    const int index = texture_of(texture);
    if (index < 0) return;
    Json info{{"index", index}};
    if (texture.coordinates != 0) info["texCoord"] = texture.coordinates;
    if (factor_key != nullptr && factor != 1.0) info[factor_key] = factor;
    if (texture.transformed()) {
      Json transform = Json::object();
      if (texture.offset != Vec2(0.0)) transform["offset"] = {texture.offset.x, texture.offset.y};
      if (texture.rotation != 0.0) transform["rotation"] = texture.rotation;
      if (texture.scale != Vec2(1.0)) transform["scale"] = {texture.scale.x, texture.scale.y};
      add_extension(info, "KHR_texture_transform", std::move(transform));
    }
    object[key] = std::move(info);
  }

  int texture_of(const Texture& texture) {
    if (!texture.there()) return -1;
    const int image = image_of(texture.image);
    if (image < 0) return -1;
    const int sampler = sampler_of({texture.wrap_u, texture.wrap_v, texture.nearest_filter});
    const auto [known, is_new] = texture_index_.try_emplace({image, sampler}, static_cast<int>(textures_.size()));
    if (is_new) textures_.push_back({{"sampler", sampler}, {"source", image}});
    return known->second;
  }

  int image_of(int source) {
    const EncodedImage& image = model_.images[source];
    const char* type = mime_type(image.bytes);
    if (type == nullptr) return -1;
    const auto [known, is_new] = image_index_.try_emplace(source, static_cast<int>(images_.size()));
    if (!is_new) return known->second;
    Json out;
    if (!image.name.empty()) out["name"] = image.name;
    out["bufferView"] = glb_.add_bytes(image.bytes);
    out["mimeType"] = type;
    images_.push_back(std::move(out));
    return known->second;
  }

  int sampler_of(const Sampler& sampler) {
    const auto [known, is_new] = sampler_index_.try_emplace(sampler, static_cast<int>(samplers_.size()));
    if (!is_new) return known->second;
    const auto [wrap_u, wrap_v, nearest] = sampler;
    samplers_.push_back({{"magFilter", nearest ? gl_nearest : gl_linear},
                         {"minFilter", nearest ? gl_nearest : gl_linear_mipmap_linear},
                         {"wrapS", wrap_code(wrap_u)},
                         {"wrapT", wrap_code(wrap_v)}});
    return known->second;
  }

  const Model& model_;
  GlbBuilder& glb_;
  Json textures_ = Json::array(), samplers_ = Json::array(), images_ = Json::array();
  std::map<std::pair<int, int>, int> texture_index_;
  std::map<Sampler, int> sampler_index_;
  std::map<int, int> image_index_;
  std::set<std::string> extensions_;
};

}  // namespace

void write_materials(const Model& model, GlbBuilder& glb) { MaterialWriter(model, glb).run(); }

}  // namespace sinew
