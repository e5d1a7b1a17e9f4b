#pragma once
/// Materials, textures and images: the base colour only (glTF 2.0 sections 3.8 and 3.9).

#include <vector>

#include "engine/core/result.h"
#include "engine/io/gltf_document.h"
#include "engine/model/model.h"

namespace sinew::gltf {

/// Which texture coordinates a material's base colour is looked up with, and what is done to them before:
/// KHR_texture_transform, uv' = offset + rotation (scale uv).
struct TextureUse {
  int set = 0;  ///< n of TEXCOORD_n
  Vec2 offset{0.0};
  double rotation = 0.0;  ///< radians, counter-clockwise as the picture is seen (v points down)
  Vec2 scale{1.0};

  Vec2 apply(const Vec2& uv) const;
};

struct Materials {
  std::vector<Material> materials;
  std::vector<TextureUse> uses;  ///< [materials]
};

/// Never fails: a material with a fault is read as far as it goes, and the fault noted.
Materials read_materials(Document& document);

/// All images, still encoded. One that cannot be found, or is neither PNG nor JPEG, is left empty and noted; fails only
/// where the images take more memory than a model may.
Result<std::vector<EncodedImage>> read_images(Document& document);

}  // namespace sinew::gltf
