#pragma once
/// The images that a window shows in turn. Vulkan types inside: engine/view's own.

#include <functional>

#include "engine/gpu/vulkan.h"

namespace sinew {

class Swapchain {
 public:
  /// `uncapped`: shows pictures as fast as they come. Throws vk::SystemError, as all members do.
  Swapchain(VulkanDevice& vulkan, vk::SurfaceKHR surface, bool uncapped);

  /// Makes images of this size where they have another.
  void resize(int width, int height);
  std::uint32_t images() const { return static_cast<std::uint32_t>(images_.size()); }
  VkRenderPass render_pass() const { return static_cast<VkRenderPass>(*render_pass_); }

  /// Shows a picture, in the layout eTransferSrcOptimal and of the same size, with what `record` draws over it. Images
  /// that no longer fit the window are made anew at the next resize(), and nothing is shown until then.
  void show(vk::Image picture, const std::function<void(const vk::raii::CommandBuffer&)>& record);

 private:
  void create(vk::Extent2D extent);

  VulkanDevice& vulkan_;
  vk::SurfaceKHR surface_;
  bool uncapped_;
  vk::Extent2D extent_;
  vk::Format format_ = vk::Format::eUndefined;
  vk::ColorSpaceKHR space_ = vk::ColorSpaceKHR::eSrgbNonlinear;
  vk::raii::RenderPass render_pass_ = nullptr;
  vk::raii::SwapchainKHR chain_ = nullptr;
  std::vector<vk::Image> images_;
  std::vector<vk::raii::ImageView> views_;
  std::vector<vk::raii::Framebuffer> framebuffers_;
  std::vector<vk::raii::Semaphore> drawn_;  ///< [images]
  vk::raii::Semaphore acquired_ = nullptr;
  vk::raii::Fence done_ = nullptr;
};

}  // namespace sinew
