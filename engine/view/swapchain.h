#pragma once
/// The images that a window shows in turn. Vulkan types inside: engine/view's own.

#include <functional>

#include "engine/gpu/vulkan.h"

namespace sinew {

/// What a window shows: a picture, and the interface over it.
struct WindowContent {
  using Draw = std::function<void(const vk::raii::CommandBuffer&)>;

  vk::Image picture;  ///< in the layout eTransferSrcOptimal
  vk::Extent2D size;  ///< its own
  vk::Offset2D at;    ///< its upper left corner in the window; panels cover all beside it
  vk::Format format = vk::Format::eUndefined;
  Draw under;  ///< what the panels cover; empty: nothing

  /// A part of the window whose pixels are kept.
  struct Panel {
    vk::Rect2D place;
    Draw redraw;  ///< draws all that has changed; empty: nothing has
  };
  std::vector<Panel> panels;
  Draw over;
};

class Swapchain {
 public:
  /// `uncapped`: shows pictures as fast as they come. Throws vk::SystemError, as all members do.
  Swapchain(VulkanDevice& vulkan, vk::SurfaceKHR surface, bool uncapped);

  /// Makes images of this size where they have another.
  void resize(int width, int height);
  VkRenderPass render_pass() const { return static_cast<VkRenderPass>(*render_pass_); }

  /// Counts how often the images, and what is kept of the panels, were made anew.
  int generation() const { return generation_; }

  /// Images that no longer fit the window are made anew at the next resize(), and nothing is shown until then.
  void show(const WindowContent& content);

 private:
  void create(vk::Extent2D extent);
  void record(const vk::raii::CommandBuffer& commands, const WindowContent& content, std::uint32_t index) const;
  void record_interface(const vk::raii::CommandBuffer& commands, const vk::raii::RenderPass& pass,
                        const vk::raii::Framebuffer& framebuffer, const WindowContent::Draw& draw) const;

  VulkanDevice& vulkan_;
  vk::SurfaceKHR surface_;
  bool uncapped_;
  vk::Extent2D extent_;
  vk::Format format_ = vk::Format::eUndefined;
  vk::ColorSpaceKHR space_ = vk::ColorSpaceKHR::eSrgbNonlinear;
  vk::raii::RenderPass render_pass_ = nullptr;        ///< ends ready to be shown
  vk::raii::RenderPass inner_render_pass_ = nullptr;  ///< ends ready to be copied
  vk::raii::SwapchainKHR chain_ = nullptr;
  std::vector<vk::Image> images_;
  std::vector<vk::raii::ImageView> views_;
  std::vector<vk::raii::Framebuffer> framebuffers_;
  std::vector<vk::raii::Semaphore> drawn_;  ///< [images]
  DeviceImage kept_;                        ///< the panels' pixels, in the layout eTransferSrcOptimal between frames
  vk::raii::Framebuffer kept_framebuffer_ = nullptr;
  int generation_ = 0;
  vk::raii::Semaphore acquired_ = nullptr;
  vk::raii::Fence done_ = nullptr;
};

}  // namespace sinew
