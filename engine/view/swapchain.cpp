#include "engine/view/swapchain.h"

#include <algorithm>

namespace sinew {
namespace {

/// Numbers are shown as they are: pictures and interface hold sRGB already.
vk::SurfaceFormatKHR choose_format(const std::vector<vk::SurfaceFormatKHR>& formats) {
  for (const vk::Format wanted : {vk::Format::eB8G8R8A8Unorm, vk::Format::eR8G8B8A8Unorm})
    for (const vk::SurfaceFormatKHR& format : formats)
      if (format.format == wanted) return format;
  return formats.front();
}

vk::PresentModeKHR choose_mode(const std::vector<vk::PresentModeKHR>& modes, bool uncapped) {
  if (uncapped)
    for (const vk::PresentModeKHR wanted : {vk::PresentModeKHR::eImmediate, vk::PresentModeKHR::eMailbox})
      if (std::ranges::find(modes, wanted) != modes.end()) return wanted;
  return vk::PresentModeKHR::eFifo;
}

/// Draws over what an image in the layout eColorAttachmentOptimal holds.
vk::raii::RenderPass make_render_pass(const VulkanDevice& vulkan, vk::Format format, vk::ImageLayout after) {
  using Layout = vk::ImageLayout;
  const vk::AttachmentDescription colour({}, format, vk::SampleCountFlagBits::e1, vk::AttachmentLoadOp::eLoad,
                                         vk::AttachmentStoreOp::eStore, vk::AttachmentLoadOp::eDontCare,
                                         vk::AttachmentStoreOp::eDontCare, Layout::eColorAttachmentOptimal, after);
  const vk::AttachmentReference reference(0, Layout::eColorAttachmentOptimal);
  const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, {}, reference);
  return {vulkan.device, vk::RenderPassCreateInfo({}, colour, subpass)};
}

void change_layout(const vk::raii::CommandBuffer& commands, vk::Image image, vk::PipelineStageFlags2 from_stage,
                   vk::AccessFlags2 from_access, vk::PipelineStageFlags2 to_stage, vk::AccessFlags2 to_access,
                   vk::ImageLayout from, vk::ImageLayout to) {
  const vk::ImageMemoryBarrier2 barrier(from_stage, from_access, to_stage, to_access, from, to, VK_QUEUE_FAMILY_IGNORED,
                                        VK_QUEUE_FAMILY_IGNORED, image, {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1});
  commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barrier));
}

constexpr vk::PipelineStageFlags2 copying = vk::PipelineStageFlagBits2::eCopy | vk::PipelineStageFlagBits2::eBlit;
constexpr vk::PipelineStageFlags2 drawing = vk::PipelineStageFlagBits2::eColorAttachmentOutput;
constexpr vk::AccessFlags2 drawn =
    vk::AccessFlagBits2::eColorAttachmentRead | vk::AccessFlagBits2::eColorAttachmentWrite;
const vk::ImageSubresourceLayers layers(vk::ImageAspectFlagBits::eColor, 0, 0, 1);

/// From being copied to to being drawn to.
void make_drawable(const vk::raii::CommandBuffer& commands, vk::Image image) {
  change_layout(commands, image, copying, vk::AccessFlagBits2::eTransferWrite, drawing, drawn,
                vk::ImageLayout::eTransferDstOptimal, vk::ImageLayout::eColorAttachmentOptimal);
}

/// Copies the picture as it is, whatever the order of the channels, as far as it lies in the window: one that has just
/// become smaller may show a picture of before.
void record_picture(const vk::raii::CommandBuffer& commands, const WindowContent& content, vk::Image to,
                    vk::Format format, vk::Extent2D extent) {
  using Layout = vk::ImageLayout;
  change_layout(commands, to, drawing, vk::AccessFlagBits2::eNone, copying, vk::AccessFlagBits2::eTransferWrite,
                Layout::eUndefined, Layout::eTransferDstOptimal);
  const vk::Offset3D at(content.at, 0);
  const int width = std::min(static_cast<int>(content.size.width), static_cast<int>(extent.width) - at.x);
  const int height = std::min(static_cast<int>(content.size.height), static_cast<int>(extent.height) - at.y);
  if (width <= 0 || height <= 0) return;
  if (content.format == format) {
    const vk::Extent3D size(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 1);
    commands.copyImage(content.picture, Layout::eTransferSrcOptimal, to, Layout::eTransferDstOptimal,
                       vk::ImageCopy(layers, {}, layers, at, size));
    return;
  }
  const std::array<vk::Offset3D, 2> from{vk::Offset3D(0, 0, 0), vk::Offset3D(width, height, 1)};
  const std::array<vk::Offset3D, 2> onto{at, vk::Offset3D(at.x + width, at.y + height, 1)};
  commands.blitImage(content.picture, Layout::eTransferSrcOptimal, to, Layout::eTransferDstOptimal,
                     vk::ImageBlit(layers, from, layers, onto), vk::Filter::eNearest);
}

}  // namespace

Swapchain::Swapchain(VulkanDevice& vulkan, vk::SurfaceKHR surface, bool uncapped)
    : vulkan_(vulkan), surface_(surface), uncapped_(uncapped) {
  const vk::SurfaceFormatKHR format = choose_format(vulkan.physical.getSurfaceFormatsKHR(surface));
  format_ = format.format;
  space_ = format.colorSpace;
  render_pass_ = make_render_pass(vulkan, format_, vk::ImageLayout::ePresentSrcKHR);
  inner_render_pass_ = make_render_pass(vulkan, format_, vk::ImageLayout::eColorAttachmentOptimal);
  acquired_ = vk::raii::Semaphore(vulkan.device, vk::SemaphoreCreateInfo());
  done_ = vk::raii::Fence(vulkan.device, vk::FenceCreateInfo());
}

void Swapchain::resize(int width, int height) {
  const vk::SurfaceCapabilitiesKHR can = vulkan_.physical.getSurfaceCapabilitiesKHR(surface_);
  vk::Extent2D extent = can.currentExtent;
  if (extent.width == ~0u)
    extent =
        vk::Extent2D(std::clamp(static_cast<uint32_t>(width), can.minImageExtent.width, can.maxImageExtent.width),
                     std::clamp(static_cast<uint32_t>(height), can.minImageExtent.height, can.maxImageExtent.height));
  if (extent.width == 0 || extent.height == 0 || extent == extent_) return;
  create(extent);
}

void Swapchain::create(vk::Extent2D extent) {
  vulkan_.device.waitIdle();
  const vk::SurfaceCapabilitiesKHR can = vulkan_.physical.getSurfaceCapabilitiesKHR(surface_);
  const uint32_t most = can.maxImageCount == 0 ? ~0u : can.maxImageCount;
  vk::SwapchainCreateInfoKHR info;
  info.surface = surface_;
  info.minImageCount = std::clamp(can.minImageCount + 1, 2u, most);
  info.imageFormat = format_;
  info.imageColorSpace = space_;
  info.imageExtent = extent;
  info.imageArrayLayers = 1;
  info.imageUsage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferDst;
  info.preTransform = can.currentTransform;
  info.compositeAlpha = vk::CompositeAlphaFlagBitsKHR::eOpaque;
  info.presentMode = choose_mode(vulkan_.physical.getSurfacePresentModesKHR(surface_), uncapped_);
  info.clipped = true;
  info.oldSwapchain = *chain_;
  framebuffers_.clear();
  views_.clear();
  drawn_.clear();
  chain_ = vk::raii::SwapchainKHR(vulkan_.device, info);
  images_.clear();
  for (const auto& image : chain_.getImages()) images_.push_back(vk::Image(image));
  for (const vk::Image image : images_) {
    const vk::ImageSubresourceRange whole(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
    views_.emplace_back(vulkan_.device, vk::ImageViewCreateInfo({}, image, vk::ImageViewType::e2D, format_, {}, whole));
    framebuffers_.emplace_back(
        vulkan_.device, vk::FramebufferCreateInfo({}, *render_pass_, *views_.back(), extent.width, extent.height, 1));
    drawn_.emplace_back(vulkan_.device, vk::SemaphoreCreateInfo());
  }
  using Usage = vk::ImageUsageFlagBits;
  kept_ = vulkan_.create_image(
      vk::ImageCreateInfo({}, vk::ImageType::e2D, format_, vk::Extent3D(extent, 1), 1, 1, vk::SampleCountFlagBits::e1,
                          vk::ImageTiling::eOptimal, Usage::eColorAttachment | Usage::eTransferSrc),
      vk::ImageAspectFlagBits::eColor);
  kept_framebuffer_ = vk::raii::Framebuffer(
      vulkan_.device, vk::FramebufferCreateInfo({}, *inner_render_pass_, *kept_.view, extent.width, extent.height, 1));
  vulkan_.run([&](vk::raii::CommandBuffer& commands) {
    change_layout(commands, *kept_.image, drawing, {}, copying, vk::AccessFlagBits2::eTransferRead,
                  vk::ImageLayout::eUndefined, vk::ImageLayout::eTransferSrcOptimal);
  });
  ++generation_;
  extent_ = extent;
}

void Swapchain::record_interface(const vk::raii::CommandBuffer& commands, const vk::raii::RenderPass& pass,
                                 const vk::raii::Framebuffer& framebuffer, const WindowContent::Draw& draw) const {
  commands.beginRenderPass(vk::RenderPassBeginInfo(*pass, *framebuffer, {{0, 0}, extent_}),
                           vk::SubpassContents::eInline);
  if (draw) draw(commands);
  commands.endRenderPass();
}

void Swapchain::record(const vk::raii::CommandBuffer& commands, const WindowContent& content,
                       std::uint32_t index) const {
  using Layout = vk::ImageLayout;
  using Access = vk::AccessFlagBits2;
  const vk::Image image = images_[index];
  if (std::ranges::any_of(content.panels, [](const auto& panel) { return bool(panel.redraw); })) {
    change_layout(commands, *kept_.image, copying, Access::eNone, drawing, drawn, Layout::eTransferSrcOptimal,
                  Layout::eColorAttachmentOptimal);
    record_interface(commands, inner_render_pass_, kept_framebuffer_, [&](const vk::raii::CommandBuffer& drawn_to) {
      for (const WindowContent::Panel& panel : content.panels)
        if (panel.redraw) panel.redraw(drawn_to);
    });
    change_layout(commands, *kept_.image, drawing, Access::eColorAttachmentWrite, copying, Access::eTransferRead,
                  Layout::eColorAttachmentOptimal, Layout::eTransferSrcOptimal);
  }
  record_picture(commands, content, image, format_, extent_);
  if (content.under) {
    make_drawable(commands, image);
    record_interface(commands, inner_render_pass_, framebuffers_[index], content.under);
    change_layout(commands, image, drawing, Access::eColorAttachmentWrite, copying, Access::eTransferWrite,
                  Layout::eColorAttachmentOptimal, Layout::eTransferDstOptimal);
  } else if (!content.panels.empty()) {
    const vk::MemoryBarrier2 copied(copying, Access::eTransferWrite, copying, Access::eTransferWrite);
    commands.pipelineBarrier2(vk::DependencyInfo({}, copied));
  }
  std::vector<vk::ImageCopy> copies;
  for (const WindowContent::Panel& panel : content.panels) {
    const vk::Offset3D at(panel.place.offset, 0);
    copies.emplace_back(layers, at, layers, at, vk::Extent3D(panel.place.extent, 1));
  }
  if (!copies.empty())
    commands.copyImage(*kept_.image, Layout::eTransferSrcOptimal, image, Layout::eTransferDstOptimal, copies);
  make_drawable(commands, image);
  record_interface(commands, render_pass_, framebuffers_[index], content.over);
}

void Swapchain::show(const WindowContent& content) {
  constexpr std::uint64_t forever = ~0ull;
  if (extent_ == vk::Extent2D()) return;
  std::uint32_t index = 0;
  try {
    index = chain_.acquireNextImage(forever, *acquired_).second;
  } catch (const vk::OutOfDateKHRError&) {
    extent_ = vk::Extent2D();
    return;
  }
  vk::raii::CommandBuffer commands = vulkan_.begin_commands();
  record(commands, content, index);
  commands.end();
  const vk::PipelineStageFlags stage =
      vk::PipelineStageFlagBits::eColorAttachmentOutput | vk::PipelineStageFlagBits::eTransfer;
  vulkan_.queue.submit(vk::SubmitInfo(*acquired_, stage, *commands, *drawn_[index]), *done_);
  if (vulkan_.device.waitForFences(*done_, true, forever) != vk::Result::eSuccess)
    throw vk::DeviceLostError("a frame was never done");
  vulkan_.device.resetFences(*done_);
  try {
    if (vulkan_.queue.presentKHR(vk::PresentInfoKHR(*drawn_[index], *chain_, index)) == vk::Result::eSuboptimalKHR)
      extent_ = vk::Extent2D();
  } catch (const vk::OutOfDateKHRError&) {
    extent_ = vk::Extent2D();
  }
}

}  // namespace sinew
