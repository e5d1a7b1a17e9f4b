#pragma once
/// What is transparent, in the right order whatever the order of its triangles: depth peeling (Everitt 2001). Layer by
/// layer from the eye the nearest surface behind the last layer is found; then the layers are blended from the
/// farthest to the nearest. What lies behind the last layer is blended first, in the order of its triangles. Vulkan
/// types inside: engine/render only.

#include <functional>

#include "engine/render/draw_pipelines.h"

namespace sinew {

class TransparentLayers {
 public:
  /// So many overlapping surfaces are sorted exactly: two layers of hair before two lashes, a cornea and an eye's
  /// glaze.
  static constexpr uint32_t count = 6;

  /// Throws vk::SystemError. The target must outlive the layers.
  static TransparentLayers create(VulkanDevice& vulkan, const Target& target,
                                  const vk::raii::DescriptorSetLayout& layout);

  /// Draws all that is transparent for a pass, with this descriptor set bound as set 2.
  using Draw = std::function<void(DrawPass, vk::DescriptorSet)>;

  /// Peels and blends. The target has been drawn to, its depth stored, and is not between begin() and end().
  void record(const vk::raii::CommandBuffer& commands, const Target& target, const Draw& draw) const;

 private:
  void peel(const vk::raii::CommandBuffer& commands, const Target& target, uint32_t layer, const Draw& draw) const;

  std::vector<DeviceImage> depths_;      ///< [count]
  DeviceImage nearest_;                  ///< depth 0 everywhere: the layer before the first
  std::vector<vk::DescriptorSet> sets_;  ///< [count + 1] set i reads the layer before layer i
  vk::raii::DescriptorPool pool_ = nullptr;
  vk::raii::Sampler sampler_ = nullptr;
};

}  // namespace sinew
