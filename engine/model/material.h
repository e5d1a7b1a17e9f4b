#pragma once
/// How a surface looks: glTF 2.0's metallic-roughness material. Colours are linear.

#include <cmath>
#include <string>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

enum class AlphaMode { opaque, mask, blend };
enum class Wrap { repeat, clamp, mirror };

/// A picture laid over a surface, and where it lies on it (KHR_texture_transform).
struct Texture {
  int image = -1;       ///< index into Model::images, -1: none
  int coordinates = 0;  ///< which of the primitive's two sets of texture coordinates it is looked up with
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  bool nearest_filter = false;
  Vec2 offset{0.0};
  double rotation = 0.0;  ///< radians, counter-clockwise as the picture is seen (v points down)
  Vec2 scale{1.0};

  bool there() const { return image >= 0; }
  bool transformed() const { return offset != Vec2(0.0) || rotation != 0.0 || scale != Vec2(1.0); }
  /// The 2x2 matrix of uv' = offset + rotation (scale uv), by columns.
  glm::dmat2 turn_and_scale() const {
    const double c = std::cos(rotation), s = std::sin(rotation);
    return {Vec2(c, -s) * scale.x, Vec2(s, c) * scale.y};
  }
  Vec2 apply(const Vec2& uv) const { return offset + turn_and_scale() * uv; }

  bool operator==(const Texture&) const = default;
};

struct Material {
  std::string name;
  Vec4 base_colour{1.0};   ///< linear RGBA factor of the base colour texture and the vertex colours
  double metallic = 0.0;   ///< 0 to 1, factor of the texture's blue
  double roughness = 0.7;  ///< 0 to 1, factor of the texture's green
  double normal_scale = 1.0;
  double occlusion_strength = 1.0;  ///< 0 to 1: how much of the texture's red darkens the light from all round
  Vec3 emissive{0.0};               ///< may exceed 1 (KHR_materials_emissive_strength)
  double specular = 1.0;            ///< of what is not metal (KHR_materials_specular), 1: 4 % at normal incidence
  Vec3 specular_colour{1.0};
  Texture base_colour_texture, metallic_roughness_texture, normal_texture, occlusion_texture, emissive_texture;
  bool unlit = false;  ///< shows its base colour as it is (KHR_materials_unlit)
  bool double_sided = false;
  AlphaMode alpha_mode = AlphaMode::opaque;
  double alpha_cutoff = 0.5;
};

/// A picture as the file stores it, not yet decoded.
struct EncodedImage {
  std::string name;
  std::vector<unsigned char> bytes;  ///< PNG or JPEG; empty where it could not be found (Model::problems says so)
};

}  // namespace sinew
