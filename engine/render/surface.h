#pragma once
/// What drawing one character takes besides its deformed vertices: triangles, what the vertices carry, materials.
/// Vulkan types inside: engine/render only.

#include "engine/gpu/gpu_deformer_impl.h"
#include "engine/render/texture.h"

namespace sinew {

struct SurfaceMaterial {
  vk::DescriptorSet set;
  uint32_t maps = 0;   ///< layout::map_... bits
  uint32_t alpha = 0;  ///< layout::alpha_...
  bool unlit = false;
  bool double_sided = false;
  /// Drawn by the rich shaders: it asks for more than a base colour with one set of coordinates.
  bool rich = false;
};

/// A run of triangles with one look.
struct SurfacePart {
  uint32_t first_index = 0, index_count = 0;
  std::size_t material = 0;
  bool mirrored = false;
};

/// What a surface is made of.
struct SurfaceContent {
  const Model& model;
  const CharacterMesh& mesh;
  std::span<const std::uint32_t> triangles;    ///< may number `duplicates` after the mesh's own vertices
  std::span<const RigidDuplicate> duplicates;  ///< of a rigid split
  std::span<const double> weights;             ///< [mesh.vertices] shown in place of vertex colours, or empty
};

struct Surface {
  Buffer texture_coordinates, indices, material_uniforms;
  /// Of the rich shaders; there only where a part is drawn by them.
  Buffer second_texture_coordinates, colours;
  std::vector<SurfaceMaterial> materials;
  std::vector<SurfacePart> parts;
  bool blended = false;  ///< any part is
  std::optional<TextureSet> textures;
  vk::raii::DescriptorPool descriptor_pool = nullptr;

  const SurfaceMaterial& material(const SurfacePart& part) const { return materials[part.material]; }

  /// Throws vk::SystemError. `material_layout` is the draw pass's set 1.
  static Surface create(VulkanDevice& vulkan, const SurfaceContent& content,
                        const vk::raii::DescriptorSetLayout& material_layout, std::vector<std::string>& problems);
};

/// The layout of a material's set: its numbers, then its textures.
vk::raii::DescriptorSetLayout create_material_layout(VulkanDevice& vulkan);

}  // namespace sinew
