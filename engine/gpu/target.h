#pragma once
/// Where pictures are drawn to: colour and depth, resolved to one sample and copied to the host. Vulkan types inside:
/// engine/gpu and engine/render only.

#include "engine/gpu/vulkan.h"

namespace sinew {

struct Target {
  uint32_t width = 0, height = 0;
  vk::SampleCountFlagBits samples = vk::SampleCountFlagBits::e1;
  DeviceImage colour;        ///< one sample, R8G8B8A8 holding sRGB numbers
  DeviceImage multisampled;  ///< the image that is drawn to where samples > 1
  DeviceImage depth;
  Buffer readback;  ///< [height * width * 4] rows from the top

  static constexpr vk::Format colour_format = vk::Format::eR8G8B8A8Unorm;
  static constexpr vk::Format depth_format = vk::Format::eD32Sfloat;

  static Target create(VulkanDevice& vulkan, uint32_t width, uint32_t height, vk::SampleCountFlagBits samples);

  /// Clears, and begins drawing. `background`: sRGB and alpha, 0 to 1.
  void begin(const vk::raii::CommandBuffer& commands, const std::array<float, 4>& background) const;
  /// Ends drawing; resolves several samples.
  void end(const vk::raii::CommandBuffer& commands) const;
  /// Copies the picture to `readback`.
  void record_copy(const vk::raii::CommandBuffer& commands) const;
};

}  // namespace sinew
