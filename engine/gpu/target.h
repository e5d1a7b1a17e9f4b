#pragma once
/// Where pictures are drawn to: colour and depth, resolved to one sample and copied to the host. Vulkan types inside:
/// engine/gpu and engine/render only.

#include "engine/gpu/vulkan.h"

namespace sinew {

struct Target {
  uint32_t width = 0, height = 0;
  vk::SampleCountFlagBits samples = vk::SampleCountFlagBits::e1;
  vk::Format colour_format = vk::Format::eR8G8B8A8Unorm;  ///< or eB8G8R8A8Unorm, as windows have it
  DeviceImage colour;                                     ///< one sample, holding sRGB numbers
  DeviceImage multisampled;                               ///< the image that is drawn to where samples > 1
  DeviceImage depth;
  Buffer readback;  ///< [height * width * 4] rows from the top, channels in the format's order

  static constexpr vk::Format depth_format = vk::Format::eD32Sfloat;

  static Target create(VulkanDevice& vulkan, uint32_t width, uint32_t height, vk::SampleCountFlagBits samples,
                       vk::Format colour_format);

  /// A further depth image of the same size and samples, which shaders can read.
  DeviceImage create_depth(VulkanDevice& vulkan) const;

  /// Clears it, and begins drawing in it. `background`: sRGB and alpha, 0 to 1. `last`: no resume() follows.
  void begin(const vk::raii::CommandBuffer& commands, const std::array<float, 4>& background, bool last) const;
  /// Goes on drawing over what is there, tested against a depth image in the layout eDepthReadOnlyOptimal that is not
  /// written. `last`: no further resume() follows; several samples are resolved.
  void resume(const vk::raii::CommandBuffer& commands, const DeviceImage& tested_depth, bool last) const;
  void end(const vk::raii::CommandBuffer& commands) const;
  /// Copies the picture to `readback`.
  void record_copy(const vk::raii::CommandBuffer& commands) const;

 private:
  vk::RenderingAttachmentInfo colour_attachment(vk::AttachmentLoadOp load, bool last) const;
};

/// Sets viewport and scissor to the whole of an image of this size.
void cover(const vk::raii::CommandBuffer& commands, uint32_t width, uint32_t height);

/// Begins drawing depth alone over the whole of an image, cleared first.
void begin_depth_rendering(const vk::raii::CommandBuffer& commands, const DeviceImage& image, uint32_t width,
                           uint32_t height, float cleared);
/// Ends it; the image is then in the layout eDepthReadOnlyOptimal.
void end_depth_rendering(const vk::raii::CommandBuffer& commands, const DeviceImage& image);

/// Takes a colour image of one sample to drawing, its content dropped, and from there to reading by shaders.
void make_colour_drawable(const vk::raii::CommandBuffer& commands, const DeviceImage& image);
void make_colour_readable(const vk::raii::CommandBuffer& commands, const DeviceImage& image);

/// Takes a colour image that was drawn to to being copied from.
void make_colour_copyable(const vk::raii::CommandBuffer& commands, const DeviceImage& image);

/// Takes a depth image that was drawn to into the layout eDepthReadOnlyOptimal: for shaders, and tests that do not
/// write.
void make_depth_readable(const vk::raii::CommandBuffer& commands, const DeviceImage& image);

}  // namespace sinew
