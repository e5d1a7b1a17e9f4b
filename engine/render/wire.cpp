#include "engine/render/wire.h"

#include <algorithm>

namespace sinew {

std::vector<std::uint32_t> distinct_edges(std::span<const std::uint32_t> triangles) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(triangles.size());
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
    for (std::size_t c = 0; c < 3; ++c) edges.push_back(std::minmax(triangles[i + c], triangles[i + (c + 1) % 3]));
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<std::uint32_t> numbers;
  numbers.reserve(2 * edges.size());
  for (const auto& [low, high] : edges) numbers.insert(numbers.end(), {low, high});
  return numbers;
}

Wire Wire::create(VulkanDevice& vulkan, std::span<const std::uint32_t> triangles, const Buffer& vertices,
                  const vk::raii::DescriptorSetLayout& layout) {
  const std::vector<std::uint32_t> numbers = distinct_edges(triangles);
  Wire wire;
  wire.edge_count = static_cast<uint32_t>(numbers.size() / 2);
  const auto bytes = std::as_bytes(std::span(numbers));
  wire.edges = vulkan.create_buffer(bytes.size(), vk::BufferUsageFlagBits::eStorageBuffer, MemoryUse::device);
  vulkan.upload(wire.edges, bytes);
  const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer, 2);
  wire.pool = vk::raii::DescriptorPool(vulkan.device, vk::DescriptorPoolCreateInfo({}, 1, size));
  wire.set = vulkan.allocate_sets(wire.pool, std::array{*layout}).front();
  const vk::DescriptorBufferInfo words(*vertices.buffer, 0, VK_WHOLE_SIZE), ends(*wire.edges.buffer, 0, VK_WHOLE_SIZE);
  constexpr auto type = vk::DescriptorType::eStorageBuffer;
  vulkan.device.updateDescriptorSets({{wire.set, layout::binding_wire_vertices, 0, type, {}, words},
                                      {wire.set, layout::binding_wire_edges, 0, type, {}, ends}},
                                     {});
  return wire;
}

}  // namespace sinew
