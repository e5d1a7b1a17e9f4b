#include "engine/io/gltf_material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "engine/io/gltf_schema.h"

namespace sinew::gltf {
namespace {

using nlohmann::json;

Wrap wrap_of(int mode) {
  if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp;
  return mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirror : Wrap::repeat;
}

/// A list of exactly N finite numbers that floats can hold; false where there is none.
template <std::size_t N>
bool numbers_at(const json* value, std::array<double, N>& numbers) {
  if (value == nullptr || !value->is_array() || value->size() != N) return false;
  for (std::size_t i = 0; i < N; ++i) {
    const double x = (*value)[i].is_number() ? (*value)[i].template get<double>() : INFINITY;
    if (!(std::abs(x) < 1e30)) return false;
    numbers[i] = x;
  }
  return true;
}

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
    material.unlit = find(source_, {"extensions", "KHR_materials_unlit"}) != nullptr;
    if (find(source_, {"pbrMetallicRoughness"}) == nullptr &&
        find(source_, {"extensions", "KHR_materials_pbrSpecularGlossiness"}) != nullptr)
      read_specular_glossiness();
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
        clamped_colour({factor[0], factor[1], factor[2], factor[3]}, "pbrMetallicRoughness/baseColorFactor");
    material.metallic = clamped(from.metallicFactor, "pbrMetallicRoughness/metallicFactor");
    material.roughness = clamped(from.roughnessFactor, "pbrMetallicRoughness/roughnessFactor");
    material.base_colour_texture = texture({"pbrMetallicRoughness", "baseColorTexture"});
    material.metallic_roughness_texture = texture({"pbrMetallicRoughness", "metallicRoughnessTexture"});
  }

  /// KHR_materials_pbrSpecularGlossiness, archived but met in older files: its diffuse colour is our base colour, what
  /// is not glossy is rough, and its specular colour is taken for that of what is no metal.
  void read_specular_glossiness() {
    const char* name = "KHR_materials_pbrSpecularGlossiness";
    const json& extension = *find(source_, {"extensions", name});
    material.metallic = 0.0;
    std::array<double, 4> factor{};
    if (numbers_at(find(extension, {"diffuseFactor"}), factor))
      material.base_colour = clamped_colour(factor, "diffuseFactor");
    material.base_colour_texture = texture({"extensions", name, "diffuseTexture"});
    material.roughness = 1.0 - clamped(number(extension, "glossinessFactor", 1.0), "glossinessFactor");
  }

  void read_relief() {
    material.normal_texture = texture({"normalTexture"});
    material.normal_scale = from_.normalTexture.scale;
    material.occlusion_texture = texture({"occlusionTexture"});
    material.occlusion_strength = clamped(from_.occlusionTexture.strength, "occlusionTexture/strength");
  }

  void read_emission() {
    if (from_.emissiveFactor.size() == 3)
      for (int i = 0; i < 3; ++i) material.emissive[i] = clamped(from_.emissiveFactor[i], "emissiveFactor");
    if (const json* extension = find(source_, {"extensions", "KHR_materials_emissive_strength"}))
      material.emissive *= std::clamp(number(*extension, "emissiveStrength", 1.0), 0.0, 1e6);
    material.emissive_texture = texture({"emissiveTexture"});
  }

  void read_specular() {
    const json* extension = find(source_, {"extensions", "KHR_materials_specular"});
    if (extension == nullptr) return;
    material.specular = clamped(number(*extension, "specularFactor", 1.0), "KHR_materials_specular/specularFactor");
    std::array<double, 3> colour{};
    if (numbers_at(find(*extension, {"specularColorFactor"}), colour))
      material.specular_colour = glm::clamp(Vec3(colour[0], colour[1], colour[2]), 0.0, 25.0);
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
    int set = std::max(index_at(find(*info, {"texCoord"}), 64), 0);
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
    const json* transform = find(info, {"extensions", "KHR_texture_transform"});
    if (transform == nullptr) return;
    const auto pair = [&](const char* key, Vec2& to) {
      const json* value = find(*transform, {key});
      std::array<double, 2> numbers{};
      if (value == nullptr) return;
      if (numbers_at(value, numbers))
        to = {numbers[0], numbers[1]};
      else
        document_.problem("{}/extensions/KHR_texture_transform/{}: must be two numbers; ignored", place, key);
    };
    pair("offset", texture.offset);
    pair("scale", texture.scale);
    if (const json* rotation = find(*transform, {"rotation"})) {
      if (rotation->is_number() && std::abs(rotation->get<double>()) < 1e6)
        texture.rotation = rotation->get<double>();
      else
        document_.problem("{}/extensions/KHR_texture_transform/rotation: must be an angle in radians; ignored", place);
    }
    if (const int other = index_at(find(*transform, {"texCoord"}), 64); other >= 0) set = other;
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

  Vec4 clamped_colour(const std::array<double, 4>& c, const char* property) {
    const Vec4 colour(c[0], c[1], c[2], c[3]);
    const Vec4 clamped = glm::clamp(colour, 0.0, 1.0);
    if (colour != clamped) document_.problem("{}/{}: a colour outside 0 to 1; clamped", place_, property);
    return clamped;
  }

  double clamped(double value, const char* property) {
    if (value < 0.0 || value > 1.0)
      document_.problem("{}/{}: {:.4g} lies outside 0 to 1; clamped", place_, property, value);
    return std::clamp(value, 0.0, 1.0);
  }

  /// A number of an extension, which conform() does not see.
  double number(const json& extension, const char* key, double otherwise) {
    const json* value = find(extension, {key});
    if (value == nullptr) return otherwise;
    if (value->is_number() && std::abs(value->get<double>()) < 1e30) return value->get<double>();
    document_.problem("{}: {} must be a number; ignored", place_, key);
    return otherwise;
  }

  Document& document_;
  const tinygltf::Material& from_;
  const json& source_;
  std::string place_;
  bool any_texture_ = false;
};

bool is_png_or_jpeg(const std::vector<unsigned char>& bytes) {
  constexpr unsigned char png[] = {0x89, 'P', 'N', 'G'}, jpeg[] = {0xFF, 0xD8, 0xFF};
  const auto begins = [&](std::span<const unsigned char> with) {
    return bytes.size() > with.size() && std::equal(with.begin(), with.end(), bytes.begin());
  };
  return begins(png) || begins(jpeg);
}

void read_image_bytes(Document& document, const json& source, const std::string& place, Result<void>& memory,
                      EncodedImage& image) {
  const json* uri = find(source, {"uri"});
  const json* view = find(source, {"bufferView"});
  if (uri != nullptr && view != nullptr) document.problem("{}: has a uri and a bufferView; the uri is used", place);
  if (uri != nullptr) {
    auto fetched = document.fetch(uri->get_ref<const std::string&>());
    if (fetched)
      image.bytes = std::move(*fetched);
    else
      document.problem("{}: {}; drawn without it", place, fetched.error().message);
  } else if (view != nullptr) {
    const auto bytes = document.view(view->get<int>());
    memory = document.take_memory(bytes.size(), place);
    if (memory) image.bytes.assign(bytes.begin(), bytes.end());
  } else {
    document.problem("{}: has neither a uri nor a bufferView; drawn without it", place);
  }
}

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

Result<std::vector<EncodedImage>> read_images(Document& document) {
  std::vector<EncodedImage> images;
  const json* list = find(document.source, {"images"});
  if (list == nullptr) return images;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string place = fmt::format("images/{}", i);
    EncodedImage image;
    if (const json* name = find((*list)[i], {"name"})) image.name = name->get<std::string>();
    Result<void> memory;
    read_image_bytes(document, (*list)[i], place, memory, image);
    if (!memory) return pass_on(std::move(memory));
    if (!image.bytes.empty() && !is_png_or_jpeg(image.bytes)) {
      document.problem("{}: is neither PNG nor JPEG; drawn without it", place);
      image.bytes.clear();
    }
    images.push_back(std::move(image));
  }
  return images;
}

}  // namespace sinew::gltf
