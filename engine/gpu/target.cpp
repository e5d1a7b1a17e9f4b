#include "engine/gpu/target.h"

namespace sinew {
namespace {

using Stage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;
using Layout = vk::ImageLayout;

vk::ImageMemoryBarrier2 transition(const DeviceImage& image, vk::ImageAspectFlags aspect, Stage from_stage,
                                   vk::AccessFlags2 from_access, Stage to_stage, vk::AccessFlags2 to_access,
                                   Layout from, Layout to) {
  return {from_stage,
          from_access,
          to_stage,
          to_access,
          from,
          to,
          VK_QUEUE_FAMILY_IGNORED,
          VK_QUEUE_FAMILY_IGNORED,
          *image.image,
          vk::ImageSubresourceRange(aspect, 0, 1, 0, 1)};
}

}  // namespace

Target Target::create(VulkanDevice& vulkan, uint32_t width, uint32_t height, vk::SampleCountFlagBits samples) {
  using Usage = vk::ImageUsageFlagBits;
  Target target;
  target.width = width;
  target.height = height;
  target.samples = samples;
  const auto info = [&](vk::Format format, vk::SampleCountFlagBits count, vk::ImageUsageFlags usage) {
    return vk::ImageCreateInfo({}, vk::ImageType::e2D, format, vk::Extent3D(width, height, 1), 1, 1, count,
                               vk::ImageTiling::eOptimal, usage);
  };
  constexpr auto one = vk::SampleCountFlagBits::e1;
  target.colour = vulkan.create_image(info(colour_format, one, Usage::eColorAttachment | Usage::eTransferSrc),
                                      vk::ImageAspectFlagBits::eColor);
  target.depth =
      vulkan.create_image(info(depth_format, samples, Usage::eDepthStencilAttachment), vk::ImageAspectFlagBits::eDepth);
  if (samples != one)
    target.multisampled =
        vulkan.create_image(info(colour_format, samples, Usage::eColorAttachment | Usage::eTransientAttachment),
                            vk::ImageAspectFlagBits::eColor);
  target.readback = vulkan.create_buffer(vk::DeviceSize{4} * width * height, vk::BufferUsageFlagBits::eTransferDst,
                                         MemoryUse::readback);
  return target;
}

void Target::begin(const vk::raii::CommandBuffer& commands, const std::array<float, 4>& background) const {
  const vk::AccessFlags2 depth_access = Access::eDepthStencilAttachmentRead | Access::eDepthStencilAttachmentWrite;
  std::vector<vk::ImageMemoryBarrier2> barriers{
      transition(colour, vk::ImageAspectFlagBits::eColor, Stage::eCopy, Access::eNone, Stage::eColorAttachmentOutput,
                 Access::eColorAttachmentWrite, Layout::eUndefined, Layout::eColorAttachmentOptimal),
      transition(depth, vk::ImageAspectFlagBits::eDepth, Stage::eLateFragmentTests,
                 Access::eDepthStencilAttachmentWrite, Stage::eEarlyFragmentTests, depth_access, Layout::eUndefined,
                 Layout::eDepthAttachmentOptimal)};
  if (*multisampled.image)
    barriers.push_back(transition(multisampled, vk::ImageAspectFlagBits::eColor, Stage::eColorAttachmentOutput,
                                  Access::eColorAttachmentWrite, Stage::eColorAttachmentOutput,
                                  Access::eColorAttachmentWrite, Layout::eUndefined, Layout::eColorAttachmentOptimal));
  commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barriers));

  vk::RenderingAttachmentInfo colour_info;
  colour_info.imageLayout = Layout::eColorAttachmentOptimal;
  colour_info.loadOp = vk::AttachmentLoadOp::eClear;
  colour_info.clearValue = vk::ClearColorValue(background);
  if (*multisampled.image) {
    colour_info.imageView = *multisampled.view;
    colour_info.storeOp = vk::AttachmentStoreOp::eDontCare;
    colour_info.resolveMode = vk::ResolveModeFlagBits::eAverage;
    colour_info.resolveImageView = *colour.view;
    colour_info.resolveImageLayout = Layout::eColorAttachmentOptimal;
  } else {
    colour_info.imageView = *colour.view;
    colour_info.storeOp = vk::AttachmentStoreOp::eStore;
  }
  vk::RenderingAttachmentInfo depth_info;
  depth_info.imageView = *depth.view;
  depth_info.imageLayout = Layout::eDepthAttachmentOptimal;
  depth_info.loadOp = vk::AttachmentLoadOp::eClear;
  depth_info.storeOp = vk::AttachmentStoreOp::eDontCare;
  depth_info.clearValue = vk::ClearDepthStencilValue(1.0f, 0);

  const vk::Rect2D area({0, 0}, {width, height});
  commands.beginRendering(vk::RenderingInfo({}, area, 1, 0, colour_info, &depth_info));
  commands.setViewport(0, vk::Viewport(0, 0, static_cast<float>(width), static_cast<float>(height), 0, 1));
  commands.setScissor(0, area);
}

void Target::end(const vk::raii::CommandBuffer& commands) const { commands.endRendering(); }

void Target::record_copy(const vk::raii::CommandBuffer& commands) const {
  const auto to_source =
      transition(colour, vk::ImageAspectFlagBits::eColor, Stage::eColorAttachmentOutput, Access::eColorAttachmentWrite,
                 Stage::eCopy, Access::eTransferRead, Layout::eColorAttachmentOptimal, Layout::eTransferSrcOptimal);
  commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, to_source));
  const vk::ImageSubresourceLayers layers(vk::ImageAspectFlagBits::eColor, 0, 0, 1);
  commands.copyImageToBuffer(*colour.image, Layout::eTransferSrcOptimal, *readback.buffer,
                             vk::BufferImageCopy(0, 0, 0, layers, {0, 0, 0}, {width, height, 1}));
  const vk::MemoryBarrier2 to_host(Stage::eCopy, Access::eTransferWrite, Stage::eHost, Access::eHostRead);
  commands.pipelineBarrier2(vk::DependencyInfo({}, to_host));
}

}  // namespace sinew
