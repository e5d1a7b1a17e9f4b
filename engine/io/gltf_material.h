#pragma once
/// Materials (glTF 2.0 section 3.9; KHR_texture_transform, KHR_materials_unlit, KHR_materials_emissive_strength,
/// KHR_materials_specular's factors, KHR_materials_pbrSpecularGlossiness' diffuse colour and gloss).

#include <array>
#include <vector>

#include "engine/io/gltf_document.h"
#include "engine/model/model.h"

namespace sinew::gltf {

/// Which of a file's texture coordinates a material needs: n of TEXCOORD_n for Texture::coordinates 0 and 1. Where only
/// one is needed the second is -1.
using CoordinateSets = std::array<int, 2>;

struct Materials {
  std::vector<Material> materials;
  std::vector<CoordinateSets> sets;  ///< [materials]
};

/// Never fails: a material with a fault is read as far as it goes, and the fault noted. A texture that would need a
/// third set of coordinates is left out and noted.
Materials read_materials(Document& document);

}  // namespace sinew::gltf
