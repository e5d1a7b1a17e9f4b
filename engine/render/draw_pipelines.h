#pragma once
/// The graphics pipelines of a renderer, each made when it is first needed. Vulkan types inside: engine/render only.

#include <compare>
#include <map>

#include "engine/gpu/target.h"
#include "engine/render/surface.h"

namespace sinew {

/// What a draw is for.
enum class DrawPass {
  opaque,  ///< colour and depth
  peel,    ///< depth of one layer of what is transparent (render/layers.h)
  layer,   ///< colour of that layer, blended
  behind,  ///< colour of what lies behind the last layer, blended
  light,   ///< depth from the key light
  below,   ///< depth from below the floor
};

/// Whether a pass draws depth alone, to a map of its own, for shadows.
constexpr bool is_depth_only(DrawPass pass) { return pass == DrawPass::light || pass == DrawPass::below; }

/// A pipeline of a surface: pass, look, and what of the material its shaders do.
struct SurfaceLook {
  DrawPass pass = DrawPass::opaque;
  uint32_t shading = 0;  ///< layout::shading_...
  uint32_t maps = 0;     ///< layout::map_... bits
  uint32_t alpha = 0;    ///< layout::alpha_...
  bool unlit = false;
  bool shadows = false;
  bool rich = false;

  auto operator<=>(const SurfaceLook&) const = default;
};

/// How lines of the mesh are drawn: before the surface only, or through it.
enum class WireDepth { tested, through };

/// The layouts of the descriptor sets that all pipelines share.
struct DrawLayouts {
  vk::raii::DescriptorSetLayout frame = nullptr, material = nullptr, layers = nullptr, wire = nullptr;
  vk::raii::PipelineLayout surface = nullptr;  ///< sets frame, material, layers
  vk::raii::PipelineLayout wires = nullptr;    ///< sets frame, wire; a push constant for the ink

  static DrawLayouts create(VulkanDevice& vulkan);
};

/// Each call throws vk::SystemError where a pipeline cannot be made.
class DrawPipelines {
 public:
  DrawPipelines(VulkanDevice& vulkan, const DrawLayouts& layouts, vk::SampleCountFlagBits samples,
                vk::Format colour_format)
      : vulkan_(&vulkan), layouts_(&layouts), samples_(samples), colour_format_(colour_format) {}

  vk::Pipeline surface(const SurfaceLook& look);
  vk::Pipeline floor();
  vk::Pipeline contact();
  vk::Pipeline wire(WireDepth depth);

 private:
  VulkanDevice* vulkan_;
  const DrawLayouts* layouts_;
  vk::SampleCountFlagBits samples_;
  vk::Format colour_format_;
  std::map<SurfaceLook, vk::raii::Pipeline> surfaces_;
  std::map<WireDepth, vk::raii::Pipeline> wires_;
  vk::raii::Pipeline floor_ = nullptr, contact_ = nullptr;
};

}  // namespace sinew
