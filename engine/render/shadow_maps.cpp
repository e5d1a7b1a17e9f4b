#include "engine/render/shadow_maps.h"

namespace sinew {
namespace {

// The shade is blurred so much that fewer points carry it.
constexpr uint32_t light_side = 1024, contact_side = 128, shade_side = 80;

/// A square map, cleared and ready to be read.
template <class Map>
Map create_map(VulkanDevice& vulkan, uint32_t side, vk::Format format, vk::ImageUsageFlags drawn_to,
               vk::ImageAspectFlags aspect) {
  Map map;
  map.side = side;
  map.image = vulkan.create_image(vk::ImageCreateInfo({}, vk::ImageType::e2D, format, vk::Extent3D(side, side, 1), 1, 1,
                                                      vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal,
                                                      drawn_to | vk::ImageUsageFlagBits::eSampled),
                                  aspect);
  vulkan.run([&](vk::raii::CommandBuffer& commands) {
    map.begin(commands);
    map.end(commands);
  });
  return map;
}

}  // namespace

DepthMap DepthMap::create(VulkanDevice& vulkan, uint32_t side) {
  return create_map<DepthMap>(vulkan, side, Target::depth_format, vk::ImageUsageFlagBits::eDepthStencilAttachment,
                              vk::ImageAspectFlagBits::eDepth);
}

void DepthMap::begin(const vk::raii::CommandBuffer& commands) const {
  begin_depth_rendering(commands, image, side, side, 1.0f);
}

void DepthMap::end(const vk::raii::CommandBuffer& commands) const { end_depth_rendering(commands, image); }

ShadeMap ShadeMap::create(VulkanDevice& vulkan, uint32_t side) {
  return create_map<ShadeMap>(vulkan, side, format, vk::ImageUsageFlagBits::eColorAttachment,
                              vk::ImageAspectFlagBits::eColor);
}

void ShadeMap::begin(const vk::raii::CommandBuffer& commands) const {
  make_colour_drawable(commands, image);
  vk::RenderingAttachmentInfo colour(*image.view, vk::ImageLayout::eColorAttachmentOptimal);
  colour.loadOp = vk::AttachmentLoadOp::eClear;
  colour.storeOp = vk::AttachmentStoreOp::eStore;
  commands.beginRendering(vk::RenderingInfo({}, vk::Rect2D({0, 0}, {side, side}), 1, 0, colour));
  cover(commands, side, side);
}

void ShadeMap::end(const vk::raii::CommandBuffer& commands) const {
  commands.endRendering();
  make_colour_readable(commands, image);
}

ShadowMaps ShadowMaps::create(VulkanDevice& vulkan) {
  ShadowMaps maps;
  maps.light = DepthMap::create(vulkan, light_side);
  maps.contact = DepthMap::create(vulkan, contact_side);
  maps.shade = ShadeMap::create(vulkan, shade_side);
  // Beyond the maps nothing stands.
  constexpr auto border = vk::SamplerAddressMode::eClampToBorder;
  vk::SamplerCreateInfo info({}, vk::Filter::eLinear, vk::Filter::eLinear, vk::SamplerMipmapMode::eNearest, border,
                             border, border);
  info.borderColor = vk::BorderColor::eFloatOpaqueWhite;
  // Devices need not filter depth but where they compare it.
  info.minFilter = info.magFilter = vk::Filter::eNearest;
  maps.reading = vk::raii::Sampler(vulkan.device, info);
  info.minFilter = info.magFilter = vk::Filter::eLinear;
  info.borderColor = vk::BorderColor::eFloatOpaqueBlack;
  maps.smooth = vk::raii::Sampler(vulkan.device, info);
  info.borderColor = vk::BorderColor::eFloatOpaqueWhite;
  info.compareEnable = true;
  info.compareOp = vk::CompareOp::eLessOrEqual;
  maps.comparing = vk::raii::Sampler(vulkan.device, info);
  return maps;
}

}  // namespace sinew
