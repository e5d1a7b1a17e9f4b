#include "engine/gpu/vulkan.h"

#include <sys/mman.h>

#include <cstdint>
#include <cstring>
#include <initializer_list>

namespace sinew {
namespace {

constexpr uint64_t submit_timeout_ns = 300ull * 1'000'000'000ull;

/// The first memory type that a resource may use and that has the wanted properties, the wishes in order.
uint32_t memory_type(const VulkanDevice& vulkan, uint32_t allowed,
                     std::initializer_list<vk::MemoryPropertyFlags> wishes) {
  const vk::PhysicalDeviceMemoryProperties memory = vulkan.physical.getMemoryProperties();
  for (const vk::MemoryPropertyFlags wish : wishes)
    for (uint32_t i = 0; i < memory.memoryTypeCount; ++i)
      if ((allowed >> i & 1u) && (memory.memoryTypes[i].propertyFlags & wish) == wish) return i;
  throw vk::OutOfDeviceMemoryError("no memory type fits");
}

uint32_t memory_type(const VulkanDevice& vulkan, uint32_t allowed, MemoryUse use) {
  using Flag = vk::MemoryPropertyFlagBits;
  const vk::MemoryPropertyFlags visible = Flag::eHostVisible | Flag::eHostCoherent;
  switch (use) {
    case MemoryUse::device:
      return memory_type(vulkan, allowed, {Flag::eDeviceLocal, {}});
    case MemoryUse::upload:
      return memory_type(vulkan, allowed, {visible | Flag::eDeviceLocal, visible});
    case MemoryUse::readback:
      return memory_type(vulkan, allowed, {visible | Flag::eHostCached, visible});
  }
  throw vk::OutOfDeviceMemoryError("unknown memory use");
}

/// On a CPU a picture's lines are pages apart, and shaders that read across lines wait for the page table.
void use_large_pages(const vk::raii::DeviceMemory& memory, vk::DeviceSize size) {
  constexpr std::uintptr_t page = std::uintptr_t{2} << 20;
  if (size < page) return;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory.mapMemory(0, VK_WHOLE_SIZE));
  const std::uintptr_t first = (begin + page - 1) / page * page, last = (begin + size) / page * page;
  // Advice only: where it is not taken all works as before.
  if (first < last) ::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
  memory.unmapMemory();
}

}  // namespace

Buffer VulkanDevice::create_buffer(vk::DeviceSize size, vk::BufferUsageFlags usage, MemoryUse use) {
  Buffer result;
  result.size = std::max<vk::DeviceSize>(size, 16);
  if (use == MemoryUse::device) usage |= vk::BufferUsageFlagBits::eTransferDst;
  result.buffer = vk::raii::Buffer(device, vk::BufferCreateInfo({}, result.size, usage));
  const vk::MemoryRequirements needs = result.buffer.getMemoryRequirements();
  const uint32_t type = memory_type(*this, needs.memoryTypeBits, use);
  result.memory = vk::raii::DeviceMemory(device, vk::MemoryAllocateInfo(needs.size, type));
  result.buffer.bindMemory(*result.memory, 0);
  const auto properties = physical.getMemoryProperties().memoryTypes[type].propertyFlags;
  constexpr auto writable = vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
  if ((properties & writable) == writable) result.mapped = result.memory.mapMemory(0, VK_WHOLE_SIZE);
  return result;
}

DeviceImage VulkanDevice::create_image(const vk::ImageCreateInfo& info, vk::ImageAspectFlags aspect) {
  DeviceImage result;
  result.image = vk::raii::Image(device, info);
  const vk::MemoryRequirements needs = result.image.getMemoryRequirements();
  const uint32_t type = memory_type(*this, needs.memoryTypeBits, MemoryUse::device);
  result.memory = vk::raii::DeviceMemory(device, vk::MemoryAllocateInfo(needs.size, type));
  result.image.bindMemory(*result.memory, 0);
  const auto properties = physical.getMemoryProperties().memoryTypes[type].propertyFlags;
  if (this->info.cpu && (properties & vk::MemoryPropertyFlagBits::eHostVisible))
    use_large_pages(result.memory, needs.size);
  const vk::ImageSubresourceRange whole(aspect, 0, info.mipLevels, 0, 1);
  result.view = vk::raii::ImageView(
      device, vk::ImageViewCreateInfo({}, *result.image, vk::ImageViewType::e2D, info.format, {}, whole));
  return result;
}

void VulkanDevice::upload(const Buffer& buffer, std::span<const std::byte> data) {
  if (data.empty()) return;
  if (buffer.mapped != nullptr) {
    std::memcpy(buffer.mapped, data.data(), data.size());
    return;
  }
  const Buffer staging = create_buffer(data.size(), vk::BufferUsageFlagBits::eTransferSrc, MemoryUse::upload);
  std::memcpy(staging.mapped, data.data(), data.size());
  run([&](vk::raii::CommandBuffer& commands) {
    commands.copyBuffer(*staging.buffer, *buffer.buffer, vk::BufferCopy(0, 0, data.size()));
  });
}

vk::raii::CommandBuffer VulkanDevice::begin_commands() {
  vk::raii::CommandBuffers buffers(device, vk::CommandBufferAllocateInfo(*pool, vk::CommandBufferLevel::ePrimary, 1));
  buffers[0].begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
  return std::move(buffers[0]);
}

void VulkanDevice::submit_and_wait(vk::raii::CommandBuffer& commands) {
  commands.end();
  const vk::raii::Fence fence(device, vk::FenceCreateInfo());
  const vk::CommandBufferSubmitInfo submitted(*commands);
  queue.submit2(vk::SubmitInfo2({}, {}, submitted, {}), *fence);
  if (device.waitForFences(*fence, true, submit_timeout_ns) != vk::Result::eSuccess)
    throw vk::DeviceLostError("the device did not answer within five minutes");
}

void VulkanDevice::run(const std::function<void(vk::raii::CommandBuffer&)>& record) {
  vk::raii::CommandBuffer commands = begin_commands();
  record(commands);
  submit_and_wait(commands);
}

vk::raii::ShaderModule VulkanDevice::shader(Shader shader) {
  std::span<const uint32_t> code = shader_code(shader);
  if (shaders)
    if (const auto found = shaders->find(shader); found != shaders->end()) code = found->second;
  return {device, vk::ShaderModuleCreateInfo({}, code.size_bytes(), code.data())};
}

std::vector<vk::DescriptorSet> VulkanDevice::allocate_sets(const vk::raii::DescriptorPool& from,
                                                           std::span<const vk::DescriptorSetLayout> layouts) const {
  const vk::DescriptorSetAllocateInfo info(*from, static_cast<uint32_t>(layouts.size()), layouts.data());
  return (*device).allocateDescriptorSets(info, *device.getDispatcher());
}

}  // namespace sinew
