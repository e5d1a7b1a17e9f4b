#include <algorithm>
#include <array>
#include <initializer_list>
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
  }

 private:
  using Sampler = std::tuple<Wrap, Wrap, bool>;

  Json written(const Material& material) {
    Json surface;
    std::array<double, 4> colour;
    for (int i = 0; i < 4; ++i) colour[i] = std::clamp(material.base_colour[i], 0.0, 1.0);
    surface["baseColorFactor"] = colour;
    if (const int texture = texture_of(material); texture >= 0) surface["baseColorTexture"] = {{"index", texture}};
    // A Model knows colours only; glTF's default is metal, which most viewers show as a dark mirror.
    surface["metallicFactor"] = 0;

    Json out = Json::object();
    if (!material.name.empty()) out["name"] = material.name;
    out["pbrMetallicRoughness"] = std::move(surface);
    if (material.alpha_mode == AlphaMode::blend) out["alphaMode"] = "BLEND";
    if (material.alpha_mode == AlphaMode::mask) {
      out["alphaMode"] = "MASK";
      out["alphaCutoff"] = std::max(material.alpha_cutoff, 0.0);
    }
    if (material.double_sided) out["doubleSided"] = true;
    return out;
  }

  int texture_of(const Material& material) {
    if (material.base_colour_image < 0) return -1;
    const int image = image_of(material.base_colour_image);
    if (image < 0) return -1;
    const int sampler = sampler_of({material.wrap_u, material.wrap_v, material.nearest_filter});
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
};

}  // namespace

void write_materials(const Model& model, GlbBuilder& glb) { MaterialWriter(model, glb).run(); }

}  // namespace sinew
