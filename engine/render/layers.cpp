#include "engine/render/layers.h"

namespace sinew {

TransparentLayers TransparentLayers::create(VulkanDevice& vulkan, const Target& target,
                                            const vk::raii::DescriptorSetLayout& layout) {
  TransparentLayers layers;
  for (uint32_t i = 0; i < count; ++i) layers.depths_.push_back(target.create_depth(vulkan));
  layers.nearest_ = target.create_depth(vulkan);
  vulkan.run([&](vk::raii::CommandBuffer& commands) {
    begin_depth_rendering(commands, layers.nearest_, target.width, target.height, 0.0f);
    end_depth_rendering(commands, layers.nearest_);
  });
  layers.sampler_ = vk::raii::Sampler(vulkan.device, vk::SamplerCreateInfo());
  const vk::DescriptorPoolSize size(vk::DescriptorType::eCombinedImageSampler, 2 * (count + 1));
  layers.pool_ = vk::raii::DescriptorPool(vulkan.device, vk::DescriptorPoolCreateInfo({}, count + 1, size));
  layers.sets_ = vulkan.allocate_sets(layers.pool_, std::vector(count + 1, *layout));
  for (uint32_t i = 0; i <= count; ++i) {
    const DeviceImage& last = i == 0 ? layers.nearest_ : layers.depths_[i - 1];
    const auto image = [&](const DeviceImage& depth) {
      return vk::DescriptorImageInfo(*layers.sampler_, *depth.view, vk::ImageLayout::eDepthReadOnlyOptimal);
    };
    const vk::DescriptorImageInfo opaque = image(target.depth), peeled = image(last);
    constexpr auto type = vk::DescriptorType::eCombinedImageSampler;
    vulkan.device.updateDescriptorSets({{layers.sets_[i], layout::binding_opaque_depth, 0, type, opaque},
                                        {layers.sets_[i], layout::binding_layer_depth, 0, type, peeled}},
                                       {});
  }
  return layers;
}

void TransparentLayers::peel(const vk::raii::CommandBuffer& commands, const Target& target, uint32_t layer,
                             const Draw& draw) const {
  begin_depth_rendering(commands, depths_[layer], target.width, target.height, 1.0f);
  draw(DrawPass::peel, sets_[layer]);
  end_depth_rendering(commands, depths_[layer]);
}

void TransparentLayers::record(const vk::raii::CommandBuffer& commands, const Target& target, const Draw& draw) const {
  make_depth_readable(commands, target.depth);
  for (uint32_t i = 0; i < count; ++i) peel(commands, target, i, draw);
  target.resume(commands, target.depth, false);
  draw(DrawPass::behind, sets_[count]);
  target.end(commands);
  for (uint32_t i = count; i-- > 0;) {
    target.resume(commands, depths_[i], i == 0);
    draw(DrawPass::layer, sets_[i]);
    target.end(commands);
  }
}

}  // namespace sinew
