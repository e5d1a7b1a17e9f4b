#pragma once
/// What drawing one character takes besides its deformed vertices: triangles, texture coordinates, materials. Vulkan
/// types inside: engine/render only.

#include "engine/gpu/gpu_deformer_impl.h"

namespace sinew {

/// A texture on the device, and how it is sampled.
struct SurfaceTexture {
  DeviceImage image;
  vk::raii::Sampler sampler = nullptr;
};

/// A run of triangles with one look.
struct SurfacePart {
  uint32_t first_index = 0, index_count = 0;
  std::size_t material = 0;
  bool mirrored = false;
};

struct SurfaceMaterial {
  vk::DescriptorSet set;
  bool double_sided = false;
  bool blended = false;
};

struct Surface {
  Buffer texture_coordinates, indices, material_uniforms;
  std::vector<SurfaceTexture> textures;
  std::vector<SurfaceMaterial> materials;
  std::vector<SurfacePart> parts;  ///< opaque ones first
  vk::raii::DescriptorPool descriptor_pool = nullptr;

  /// Throws vk::SystemError. `material_layout` is the draw pass's set 1. `triangles` may number duplicates of vertices
  /// after the mesh's own: `duplicates`.
  static Surface create(VulkanDevice& vulkan, const Model& model, const CharacterMesh& mesh,
                        std::span<const std::uint32_t> triangles, std::span<const RigidDuplicate> duplicates,
                        const vk::raii::DescriptorSetLayout& material_layout, std::vector<std::string>& problems);
};

}  // namespace sinew
