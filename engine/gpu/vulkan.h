#pragma once
/// Vulkan behind Device: included by engine/gpu and engine/render only.

#include <cstddef>
#include <functional>
#include <mutex>
#include <span>

#include <vulkan/vulkan_raii.hpp>

#include "engine/gpu/device.h"
#include "engine/gpu/shader_code.h"

namespace sinew {

/// Where a buffer lives.
enum class MemoryUse {
  device,    ///< read and written by the device; filled through upload()
  upload,    ///< written by the host often, read by the device
  readback,  ///< written by the device, read by the host
};

/// A buffer with memory of its own; `mapped` is null where the host cannot see it.
struct Buffer {
  vk::raii::DeviceMemory memory = nullptr;
  vk::raii::Buffer buffer = nullptr;
  vk::DeviceSize size = 0;
  void* mapped = nullptr;

  template <class T>
  std::span<T> as() const {
    return {static_cast<T*>(mapped), static_cast<std::size_t>(size / sizeof(T))};
  }
};

struct DeviceImage {
  vk::raii::DeviceMemory memory = nullptr;
  vk::raii::Image image = nullptr;
  vk::raii::ImageView view = nullptr;
};

struct VulkanDevice {
  vk::raii::Context context;
  vk::raii::Instance instance = nullptr;
  vk::raii::DebugUtilsMessengerEXT messenger = nullptr;
  vk::raii::PhysicalDevice physical = nullptr;
  vk::raii::Device device = nullptr;
  vk::raii::Queue queue = nullptr;
  vk::raii::CommandPool pool = nullptr;
  uint32_t queue_family = 0;
  vk::PhysicalDeviceLimits limits;
  bool anisotropy = false;
  bool sample_shading = false;
  DeviceInfo info;
  std::shared_ptr<const ShaderSet> shaders;  ///< DeviceOptions::shaders
  std::mutex message_mutex;
  std::vector<std::string> messages;

  /// A buffer of at least one byte. Throws vk::SystemError where there is no memory.
  Buffer create_buffer(vk::DeviceSize size, vk::BufferUsageFlags usage, MemoryUse use);

  /// A 2-D image with one view of the whole.
  DeviceImage create_image(const vk::ImageCreateInfo& info, vk::ImageAspectFlags aspect);

  /// Copies bytes into a buffer: directly where the host can see it, through a staging buffer elsewhere.
  void upload(const Buffer& buffer, std::span<const std::byte> data);

  vk::raii::CommandBuffer begin_commands();
  /// Ends and submits the commands and waits until the device is done with them.
  void submit_and_wait(vk::raii::CommandBuffer& commands);
  void run(const std::function<void(vk::raii::CommandBuffer&)>& record);

  vk::raii::ShaderModule shader(Shader shader);

  /// One set a layout, owned by the pool, which frees them with itself.
  std::vector<vk::DescriptorSet> allocate_sets(const vk::raii::DescriptorPool& from,
                                               std::span<const vk::DescriptorSetLayout> layouts) const;
};

/// Runs a call that may throw vk::SystemError and turns what it throws into an Error of kind device_failed.
template <class Call>
auto vulkan_call(const char* what, Call&& call) -> Result<decltype(call())> {
  try {
    if constexpr (std::is_void_v<decltype(call())>) {
      call();
      return {};
    } else {
      return call();
    }
  } catch (const vk::SystemError& error) {
    return failure(ErrorKind::device_failed, "{}: the device failed: {}", what, error.what());
  }
}

}  // namespace sinew
