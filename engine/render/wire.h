#pragma once
/// The edges of a character's triangles as lines. Vulkan types inside: engine/render only.

#include "engine/render/draw_pipelines.h"

namespace sinew {

struct Wire {
  Buffer edges;
  uint32_t edge_count = 0;
  vk::raii::DescriptorPool pool = nullptr;
  vk::DescriptorSet set;

  /// Every edge of the triangles once. `vertices`: the deformed ones. Throws vk::SystemError.
  static Wire create(VulkanDevice& vulkan, std::span<const std::uint32_t> triangles, const Buffer& vertices,
                     const vk::raii::DescriptorSetLayout& layout);
};

/// The distinct edges of triangles, each with its lower index first, rising: two numbers an edge.
std::vector<std::uint32_t> distinct_edges(std::span<const std::uint32_t> triangles);

}  // namespace sinew
