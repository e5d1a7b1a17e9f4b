#include "engine/gpu/target.h"

namespace sinew {
namespace {

using Stage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;
using Layout = vk::ImageLayout;

constexpr auto depth_tests = Stage::eEarlyFragmentTests | Stage::eLateFragmentTests;
constexpr auto depth_access = Access::eDepthStencilAttachmentRead | Access::eDepthStencilAttachmentWrite;

vk::ImageMemoryBarrier2 transition(const DeviceImage& image, vk::ImageAspectFlags aspect,
                                   vk::PipelineStageFlags2 from_stage, vk::AccessFlags2 from_access,
                                   vk::PipelineStageFlags2 to_stage, vk::AccessFlags2 to_access, Layout from,
                                   Layout to) {
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

vk::ImageMemoryBarrier2 colour_to_attachment(const DeviceImage& image, vk::PipelineStageFlags2 after) {
  return transition(image, vk::ImageAspectFlagBits::eColor, after, Access::eNone, Stage::eColorAttachmentOutput,
                    Access::eColorAttachmentRead | Access::eColorAttachmentWrite, Layout::eUndefined,
                    Layout::eColorAttachmentOptimal);
}

/// Before it is drawn to; its content is dropped.
vk::ImageMemoryBarrier2 depth_to_attachment(const DeviceImage& image) {
  return transition(image, vk::ImageAspectFlagBits::eDepth, depth_tests | Stage::eFragmentShader,
                    Access::eDepthStencilAttachmentWrite, depth_tests, depth_access, Layout::eUndefined,
                    Layout::eDepthAttachmentOptimal);
}

vk::ImageCreateInfo image_info(const Target& target, vk::Format format, vk::SampleCountFlagBits samples,
                               vk::ImageUsageFlags usage) {
  return {{},      vk::ImageType::e2D,        format, vk::Extent3D(target.width, target.height, 1), 1, 1,
          samples, vk::ImageTiling::eOptimal, usage};
}

void begin_rendering(const Target& target, const vk::raii::CommandBuffer& commands,
                     const vk::RenderingAttachmentInfo& colour, const vk::RenderingAttachmentInfo& depth) {
  const vk::Rect2D whole({0, 0}, {target.width, target.height});
  commands.beginRendering(vk::RenderingInfo({}, whole, 1, 0, colour, &depth));
  cover(commands, target.width, target.height);
}

}  // namespace

void cover(const vk::raii::CommandBuffer& commands, uint32_t width, uint32_t height) {
  commands.setViewport(0, vk::Viewport(0, 0, static_cast<float>(width), static_cast<float>(height), 0, 1));
  commands.setScissor(0, vk::Rect2D({0, 0}, {width, height}));
}

void begin_depth_rendering(const vk::raii::CommandBuffer& commands, const DeviceImage& image, uint32_t width,
                           uint32_t height, float cleared) {
  const vk::ImageMemoryBarrier2 barrier = depth_to_attachment(image);
  commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barrier));
  vk::RenderingAttachmentInfo depth(*image.view, Layout::eDepthAttachmentOptimal);
  depth.loadOp = vk::AttachmentLoadOp::eClear;
  depth.storeOp = vk::AttachmentStoreOp::eStore;
  depth.clearValue = vk::ClearDepthStencilValue(cleared, 0);
  vk::RenderingInfo info;
  info.renderArea = vk::Rect2D({0, 0}, {width, height});
  info.layerCount = 1;
  info.pDepthAttachment = &depth;
  commands.beginRendering(info);
  cover(commands, width, height);
}

void end_depth_rendering(const vk::raii::CommandBuffer& commands, const DeviceImage& image) {
  commands.endRendering();
  make_depth_readable(commands, image);
}

void make_depth_readable(const vk::raii::CommandBuffer& commands, const DeviceImage& image) {
  const auto barrier =
      transition(image, vk::ImageAspectFlagBits::eDepth, depth_tests, Access::eDepthStencilAttachmentWrite,
                 depth_tests | Stage::eFragmentShader, Access::eDepthStencilAttachmentRead | Access::eShaderSampledRead,
                 Layout::eDepthAttachmentOptimal, Layout::eDepthReadOnlyOptimal);
  commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barrier));
}

void make_colour_drawable(const vk::raii::CommandBuffer& commands, const DeviceImage& image) {
  const auto barrier = colour_to_attachment(image, Stage::eFragmentShader);
  commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barrier));
}

void make_colour_readable(const vk::raii::CommandBuffer& commands, const DeviceImage& image) {
  const auto barrier = transition(image, vk::ImageAspectFlagBits::eColor, Stage::eColorAttachmentOutput,
                                  Access::eColorAttachmentWrite, Stage::eFragmentShader, Access::eShaderSampledRead,
                                  Layout::eColorAttachmentOptimal, Layout::eShaderReadOnlyOptimal);
  commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barrier));
}

void make_colour_copyable(const vk::raii::CommandBuffer& commands, const DeviceImage& image) {
  const auto barrier = transition(image, vk::ImageAspectFlagBits::eColor, Stage::eColorAttachmentOutput,
                                  Access::eColorAttachmentWrite, Stage::eCopy | Stage::eBlit, Access::eTransferRead,
                                  Layout::eColorAttachmentOptimal, Layout::eTransferSrcOptimal);
  commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barrier));
}

Target Target::create(VulkanDevice& vulkan, uint32_t width, uint32_t height, vk::SampleCountFlagBits samples,
                      vk::Format colour_format) {
  using Usage = vk::ImageUsageFlagBits;
  Target target;
  target.width = width;
  target.height = height;
  target.samples = samples;
  target.colour_format = colour_format;
  constexpr auto one = vk::SampleCountFlagBits::e1;
  target.colour = vulkan.create_image(
      image_info(target, colour_format, one, Usage::eColorAttachment | Usage::eTransferSrc | Usage::eTransferDst),
      vk::ImageAspectFlagBits::eColor);
  target.depth = target.create_depth(vulkan);
  if (samples != one)
    target.multisampled = vulkan.create_image(image_info(target, colour_format, samples, Usage::eColorAttachment),
                                              vk::ImageAspectFlagBits::eColor);
  target.readback = vulkan.create_buffer(vk::DeviceSize{4} * width * height, vk::BufferUsageFlagBits::eTransferDst,
                                         MemoryUse::readback);
  return target;
}

DeviceImage Target::create_depth(VulkanDevice& vulkan) const {
  using Usage = vk::ImageUsageFlagBits;
  return vulkan.create_image(image_info(*this, depth_format, samples, Usage::eDepthStencilAttachment | Usage::eSampled),
                             vk::ImageAspectFlagBits::eDepth);
}

vk::RenderingAttachmentInfo Target::colour_attachment(vk::AttachmentLoadOp load, bool last) const {
  const bool resolves = *multisampled.image != vk::Image();
  vk::RenderingAttachmentInfo info(resolves ? *multisampled.view : *colour.view, Layout::eColorAttachmentOptimal);
  info.loadOp = load;
  info.storeOp = resolves && last ? vk::AttachmentStoreOp::eDontCare : vk::AttachmentStoreOp::eStore;
  if (resolves && last) {
    info.resolveMode = vk::ResolveModeFlagBits::eAverage;
    info.resolveImageView = *colour.view;
    info.resolveImageLayout = Layout::eColorAttachmentOptimal;
  }
  return info;
}

void Target::begin(const vk::raii::CommandBuffer& commands, const std::array<float, 4>& background, bool last) const {
  std::vector<vk::ImageMemoryBarrier2> barriers{colour_to_attachment(colour, Stage::eCopy | Stage::eBlit),
                                                depth_to_attachment(depth)};
  if (*multisampled.image) barriers.push_back(colour_to_attachment(multisampled, Stage::eColorAttachmentOutput));
  commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barriers));

  vk::RenderingAttachmentInfo colour_info = colour_attachment(vk::AttachmentLoadOp::eClear, last);
  colour_info.clearValue = vk::ClearColorValue(background);
  vk::RenderingAttachmentInfo depth_info(*depth.view, Layout::eDepthAttachmentOptimal);
  depth_info.loadOp = vk::AttachmentLoadOp::eClear;
  depth_info.storeOp = last ? vk::AttachmentStoreOp::eDontCare : vk::AttachmentStoreOp::eStore;
  depth_info.clearValue = vk::ClearDepthStencilValue(1.0f, 0);
  begin_rendering(*this, commands, colour_info, depth_info);
}

void Target::resume(const vk::raii::CommandBuffer& commands, const DeviceImage& tested_depth, bool last) const {
  const vk::MemoryBarrier2 drawn(Stage::eColorAttachmentOutput, Access::eColorAttachmentWrite,
                                 Stage::eColorAttachmentOutput,
                                 Access::eColorAttachmentRead | Access::eColorAttachmentWrite);
  commands.pipelineBarrier2(vk::DependencyInfo({}, drawn));
  const vk::RenderingAttachmentInfo colour_info = colour_attachment(vk::AttachmentLoadOp::eLoad, last);
  vk::RenderingAttachmentInfo depth_info(*tested_depth.view, Layout::eDepthReadOnlyOptimal);
  depth_info.loadOp = vk::AttachmentLoadOp::eLoad;
  depth_info.storeOp = vk::AttachmentStoreOp::eNone;
  begin_rendering(*this, commands, colour_info, depth_info);
}

void Target::end(const vk::raii::CommandBuffer& commands) const { commands.endRendering(); }

void Target::record_copy(const vk::raii::CommandBuffer& commands) const {
  make_colour_copyable(commands, colour);
  const vk::ImageSubresourceLayers layers(vk::ImageAspectFlagBits::eColor, 0, 0, 1);
  commands.copyImageToBuffer(*colour.image, Layout::eTransferSrcOptimal, *readback.buffer,
                             vk::BufferImageCopy(0, 0, 0, layers, {0, 0, 0}, {width, height, 1}));
  const vk::MemoryBarrier2 to_host(Stage::eCopy, Access::eTransferWrite, Stage::eHost, Access::eHostRead);
  commands.pipelineBarrier2(vk::DependencyInfo({}, to_host));
}

}  // namespace sinew
