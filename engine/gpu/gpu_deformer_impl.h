#pragma once
/// GpuDeformer's Vulkan side, for whoever records it into a command buffer with more work.

#include "engine/gpu/gpu_deformer.h"
#include "engine/gpu/vulkan.h"

namespace sinew {

struct GpuDeformer::Impl {
  /// Vertices that one dispatch deforms, and the views of the buffers that it sees.
  struct Chunk {
    uint32_t vertices = 0;
    vk::raii::BufferView vertex_view = nullptr, tangent_view = nullptr;
    vk::DescriptorSet set;
  };

  VulkanDevice* vulkan = nullptr;
  std::size_t vertices = 0;
  std::size_t muscle_count = 0;
  bool texel = false;
  std::vector<PlacedMuscle> muscles;
  std::vector<RigidDuplicate> duplicates;
  std::size_t morph_slots = 0;
  std::optional<CharacterFace> face;
  Buffer vertex_words, detail_words, palette, morph_weights, muscle_words, face_words, output, readback;
  Buffer tangent_words, output_tangents;  ///< a word a vertex where there are tangents, else of one word
  bool has_tangents = false;
  vk::raii::BufferView detail_view = nullptr, palette_view = nullptr, morph_view = nullptr, muscle_view = nullptr,
                       face_view = nullptr;
  vk::raii::DescriptorSetLayout set_layout = nullptr;
  vk::raii::PipelineLayout pipeline_layout = nullptr;
  vk::raii::Pipeline pipeline = nullptr;
  vk::raii::DescriptorPool descriptor_pool = nullptr;
  std::vector<Chunk> chunks;

  /// The dispatches of one frame. The caller adds the barrier (deform_barrier) before anything reads the output.
  void record(const vk::raii::CommandBuffer& commands) const;
};

/// Makes deformed vertices visible to vertex fetch and copies: the one barrier between deforming and drawing.
void deform_barrier(const vk::raii::CommandBuffer& commands);

}  // namespace sinew
