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

void read_transform(Document& document, const json& info, const std::string& place, TextureUse& use) {
  const json* transform = find(info, {"extensions", "KHR_texture_transform"});
  if (transform == nullptr) return;
  const auto pair = [&](const char* key, Vec2& to) {
    const json* value = find(*transform, {key});
    std::array<double, 2> numbers{};
    if (value == nullptr) return;
    if (numbers_at(value, numbers))
      to = {numbers[0], numbers[1]};
    else
      document.problem("{}/extensions/KHR_texture_transform/{}: must be two numbers; ignored", place, key);
  };
  pair("offset", use.offset);
  pair("scale", use.scale);
  if (const json* rotation = find(*transform, {"rotation"})) {
    if (rotation->is_number() && std::abs(rotation->get<double>()) < 1e6)
      use.rotation = rotation->get<double>();
    else
      document.problem("{}/extensions/KHR_texture_transform/rotation: must be an angle in radians; ignored", place);
  }
  if (const int set = index_at(find(*transform, {"texCoord"}), 64); set >= 0) use.set = set;
}

void read_texture(Document& document, int texture, const std::string& place, Material& material) {
  const tinygltf::Texture& from = document.gltf.textures[static_cast<std::size_t>(texture)];
  if (from.sampler >= 0) {
    const tinygltf::Sampler& sampler = document.gltf.samplers[static_cast<std::size_t>(from.sampler)];
    material.wrap_u = wrap_of(sampler.wrapS);
    material.wrap_v = wrap_of(sampler.wrapT);
    material.nearest_filter = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  }
  material.base_colour_image = from.source;
  if (from.source < 0) document.problem("{}: textures/{} has no PNG or JPEG image; drawn without it", place, texture);
}

Vec4 clamped_colour(Document& document, const std::array<double, 4>& c, const std::string& place) {
  const Vec4 colour(c[0], c[1], c[2], c[3]);
  const Vec4 clamped = glm::clamp(colour, 0.0, 1.0);
  if (colour != clamped) document.problem("{}: a colour outside 0 to 1; clamped", place);
  return clamped;
}

/// KHR_materials_pbrSpecularGlossiness, archived but met in older files: its diffuse colour is our base colour.
void read_diffuse(Document& document, const json& source, const std::string& place, Material& material,
                  TextureUse& use) {
  const json* extension = find(source, {"extensions", "KHR_materials_pbrSpecularGlossiness"});
  if (extension == nullptr) return;
  std::array<double, 4> factor{};
  if (numbers_at(find(*extension, {"diffuseFactor"}), factor))
    material.base_colour = clamped_colour(document, factor, place + "/diffuseFactor");
  const json* info = find(*extension, {"diffuseTexture"});
  if (info == nullptr) return;
  const int texture = index_at(find(*info, {"index"}), document.gltf.textures.size());
  if (texture < 0) {
    document.problem("{}/diffuseTexture: names no texture of the file; drawn without it", place);
    return;
  }
  use.set = std::max(index_at(find(*info, {"texCoord"}), 64), 0);
  read_texture(document, texture, place + "/diffuseTexture", material);
  read_transform(document, *info, place + "/diffuseTexture", use);
}

Material read_material(Document& document, std::size_t index, TextureUse& use) {
  const tinygltf::Material& from = document.gltf.materials[index];
  const json& source = document.source["materials"][index];
  const std::string place = fmt::format("materials/{}", index);
  Material material;
  material.name = from.name;
  material.double_sided = from.doubleSided;
  material.alpha_cutoff = from.alphaCutoff;
  if (from.alphaMode == "MASK") material.alpha_mode = AlphaMode::mask;
  if (from.alphaMode == "BLEND") material.alpha_mode = AlphaMode::blend;
  const json* metallic = find(source, {"pbrMetallicRoughness"});
  if (metallic == nullptr) {
    read_diffuse(document, source, place, material, use);
    return material;
  }
  const auto& factor = from.pbrMetallicRoughness.baseColorFactor;
  material.base_colour = clamped_colour(document, {factor[0], factor[1], factor[2], factor[3]},
                                        place + "/pbrMetallicRoughness/baseColorFactor");
  const tinygltf::TextureInfo& info = from.pbrMetallicRoughness.baseColorTexture;
  if (info.index < 0) return material;
  const std::string at = place + "/pbrMetallicRoughness/baseColorTexture";
  use.set = info.texCoord;
  read_texture(document, info.index, at, material);
  read_transform(document, *find(*metallic, {"baseColorTexture"}), at, use);
  return material;
}

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

Vec2 TextureUse::apply(const Vec2& uv) const {
  const Vec2 scaled = scale * uv;
  const double c = std::cos(rotation), s = std::sin(rotation);
  return offset + Vec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x);
}

Materials read_materials(Document& document) {
  Materials read;
  for (std::size_t i = 0; i < document.gltf.materials.size(); ++i) {
    TextureUse use;
    read.materials.push_back(read_material(document, i, use));
    read.uses.push_back(use);
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
