#pragma once
/// Depth from the key light and from below the floor, drawn anew every frame. Vulkan types inside: engine/render only.

#include "engine/gpu/target.h"

namespace sinew {

/// One square depth image that is drawn to, then read.
struct DepthMap {
  uint32_t side = 0;
  DeviceImage image;

  /// In the layout for reading, holding the farthest depth everywhere.
  static DepthMap create(VulkanDevice& vulkan, uint32_t side);

  void begin(const vk::raii::CommandBuffer& commands) const;
  void end(const vk::raii::CommandBuffer& commands) const;
};

/// One square image of single bytes that is drawn to, then read.
struct ShadeMap {
  uint32_t side = 0;
  DeviceImage image;

  static constexpr vk::Format format = vk::Format::eR8Unorm;

  /// In the layout for reading, black.
  static ShadeMap create(VulkanDevice& vulkan, uint32_t side);

  void begin(const vk::raii::CommandBuffer& commands) const;
  void end(const vk::raii::CommandBuffer& commands) const;
};

struct ShadowMaps {
  DepthMap light, contact;
  ShadeMap shade;                         ///< what `contact` means for the floor's points
  vk::raii::Sampler comparing = nullptr;  ///< of `light`: how much of what lies round a point is farther
  vk::raii::Sampler reading = nullptr;    ///< of `contact`
  vk::raii::Sampler smooth = nullptr;     ///< of `shade`

  /// Throws vk::SystemError.
  static ShadowMaps create(VulkanDevice& vulkan);
};

}  // namespace sinew
