#include "engine/render/draw_pipelines.h"

#include <array>
#include <optional>

#include "engine/gpu/shader_code.h"
#include "engine/render/shadow_maps.h"

namespace sinew {
namespace {

/// How a pipeline treats depth and what lies behind.
struct DepthAndBlend {
  vk::CompareOp compare = vk::CompareOp::eLess;
  bool writes_depth = true;
  bool writes_colour = true;
  bool blends = false;
};

/// What pipelines differ in, besides their shaders' constants.
struct PipelineParts {
  Shader vertex = Shader::surface_vertex;
  std::optional<Shader> fragment;
  const vk::SpecializationInfo* constants = nullptr;
  std::span<const vk::VertexInputBindingDescription> bindings = {};
  std::span<const vk::VertexInputAttributeDescription> attributes = {};
  vk::PrimitiveTopology topology = vk::PrimitiveTopology::eTriangleList;
  vk::SampleCountFlagBits samples = vk::SampleCountFlagBits::e1;
  DepthAndBlend depth;
  vk::Format colour_format = vk::Format::eUndefined, depth_format = Target::depth_format;
  bool biased = false;  ///< pushed away from the light, so that no surface shades itself
};

vk::raii::Pipeline create(VulkanDevice& vulkan, vk::PipelineLayout layout, const PipelineParts& parts) {
  const vk::raii::ShaderModule vertex = vulkan.shader(parts.vertex);
  vk::raii::ShaderModule fragment = nullptr;
  std::vector<vk::PipelineShaderStageCreateInfo> stages{
      {{}, vk::ShaderStageFlagBits::eVertex, *vertex, "main", parts.constants}};
  if (parts.fragment) {
    fragment = vulkan.shader(*parts.fragment);
    stages.emplace_back(vk::PipelineShaderStageCreateFlags(), vk::ShaderStageFlagBits::eFragment, *fragment, "main",
                        parts.constants);
  }
  vk::PipelineVertexInputStateCreateInfo input;
  input.setVertexBindingDescriptions(parts.bindings).setVertexAttributeDescriptions(parts.attributes);
  const vk::PipelineInputAssemblyStateCreateInfo assembly({}, parts.topology);
  const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
  vk::PipelineRasterizationStateCreateInfo raster;
  raster.polygonMode = vk::PolygonMode::eFill;
  raster.lineWidth = 1.0f;
  if (parts.biased) {
    raster.depthBiasEnable = true;
    raster.depthBiasConstantFactor = 1.0f;
    raster.depthBiasSlopeFactor = 1.5f;
  }
  const vk::PipelineMultisampleStateCreateInfo multisample({}, parts.samples);
  const vk::PipelineDepthStencilStateCreateInfo depth({}, parts.depth_format != vk::Format::eUndefined,
                                                      parts.depth.writes_depth, parts.depth.compare);
  vk::PipelineColorBlendAttachmentState blend(
      parts.depth.blends, vk::BlendFactor::eSrcAlpha, vk::BlendFactor::eOneMinusSrcAlpha, vk::BlendOp::eAdd,
      vk::BlendFactor::eOne, vk::BlendFactor::eOneMinusSrcAlpha, vk::BlendOp::eAdd);
  using Component = vk::ColorComponentFlagBits;
  blend.colorWriteMask = Component::eR | Component::eG | Component::eB | Component::eA;
  vk::PipelineColorBlendStateCreateInfo blend_state;
  vk::PipelineRenderingCreateInfo rendering;
  rendering.depthAttachmentFormat = parts.depth_format;
  if (parts.depth.writes_colour) {
    blend_state.setAttachments(blend);
    rendering.setColorAttachmentFormats(parts.colour_format);
  }
  const std::array dynamic{vk::DynamicState::eViewport, vk::DynamicState::eScissor, vk::DynamicState::eCullMode,
                           vk::DynamicState::eFrontFace};
  const vk::PipelineDynamicStateCreateInfo dynamic_state({}, dynamic);
  vk::GraphicsPipelineCreateInfo info({}, stages, &input, &assembly, nullptr, &viewport, &raster, &multisample, &depth,
                                      &blend_state, &dynamic_state, layout);
  info.pNext = &rendering;
  return {vulkan.device, nullptr, info};
}

Shader vertex_shader(const SurfaceLook& look) {
  if (is_depth_only(look.pass))
    return look.alpha == layout::alpha_mask ? Shader::masked_depth_vertex : Shader::depth_vertex;
  return look.rich ? Shader::surface_rich_vertex : Shader::surface_vertex;
}

std::optional<Shader> fragment_shader(const SurfaceLook& look, bool multisampled) {
  switch (look.pass) {
    case DrawPass::opaque:
    case DrawPass::layer:
      return look.rich ? Shader::surface_rich_fragment : Shader::surface_fragment;
    case DrawPass::peel:
      return multisampled ? Shader::peel_fragment_multisampled : Shader::peel_fragment;
    case DrawPass::behind:
      return multisampled ? Shader::surface_behind_fragment_multisampled : Shader::surface_behind_fragment;
    case DrawPass::light:
    case DrawPass::below:
      break;
  }
  if (look.alpha == layout::alpha_mask) return Shader::masked_depth_fragment;
  return {};
}

DepthAndBlend depth_and_blend(DrawPass pass) {
  switch (pass) {
    case DrawPass::opaque:
      return {};
    case DrawPass::layer:
      return {vk::CompareOp::eEqual, false, true, true};
    case DrawPass::behind:
      return {vk::CompareOp::eLess, false, true, true};
    case DrawPass::peel:
    case DrawPass::light:
    case DrawPass::below:
      break;
  }
  return {vk::CompareOp::eLess, true, false, false};
}

/// The vertices' streams in the order of Surface: deformed, coordinates, tangents, second coordinates, colours.
std::vector<vk::VertexInputBindingDescription> vertex_bindings(std::size_t streams) {
  const std::array all{
      vk::VertexInputBindingDescription(0, layout::words_per_output * 16),
      vk::VertexInputBindingDescription(1, sizeof(Vec2f)), vk::VertexInputBindingDescription(2, sizeof(Vec4f)),
      vk::VertexInputBindingDescription(3, sizeof(Vec2f)), vk::VertexInputBindingDescription(4, sizeof(Vec4f))};
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(streams)};
}

std::vector<vk::VertexInputAttributeDescription> vertex_attributes(std::size_t attributes) {
  constexpr auto four = vk::Format::eR32G32B32A32Sfloat, two = vk::Format::eR32G32Sfloat;
  const std::array all{
      vk::VertexInputAttributeDescription(0, 0, four, 0), vk::VertexInputAttributeDescription(1, 0, four, 16),
      vk::VertexInputAttributeDescription(2, 1, two, 0),  vk::VertexInputAttributeDescription(3, 2, four, 0),
      vk::VertexInputAttributeDescription(4, 3, two, 0),  vk::VertexInputAttributeDescription(5, 4, four, 0)};
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(attributes)};
}

vk::raii::DescriptorSetLayout set_layout(VulkanDevice& vulkan,
                                         std::initializer_list<std::pair<uint32_t, vk::DescriptorType>> all,
                                         vk::ShaderStageFlags stages) {
  std::vector<vk::DescriptorSetLayoutBinding> bindings;
  for (const auto& [number, type] : all) bindings.emplace_back(number, type, 1, stages);
  return {vulkan.device, vk::DescriptorSetLayoutCreateInfo({}, bindings)};
}

}  // namespace

DrawLayouts DrawLayouts::create(VulkanDevice& vulkan) {
  using Type = vk::DescriptorType;
  using Stage = vk::ShaderStageFlagBits;
  DrawLayouts layouts;
  layouts.frame = set_layout(vulkan,
                             {{layout::binding_frame, Type::eUniformBuffer},
                              {layout::binding_shadow_map, Type::eCombinedImageSampler},
                              {layout::binding_contact_map, Type::eCombinedImageSampler}},
                             Stage::eVertex | Stage::eFragment);
  layouts.material = create_material_layout(vulkan);
  layouts.layers = set_layout(vulkan,
                              {{layout::binding_opaque_depth, Type::eCombinedImageSampler},
                               {layout::binding_layer_depth, Type::eCombinedImageSampler}},
                              Stage::eFragment);
  layouts.wire = set_layout(
      vulkan,
      {{layout::binding_wire_vertices, Type::eStorageBuffer}, {layout::binding_wire_edges, Type::eStorageBuffer}},
      Stage::eVertex);
  const std::array surface{*layouts.frame, *layouts.material, *layouts.layers};
  layouts.surface = vk::raii::PipelineLayout(vulkan.device, vk::PipelineLayoutCreateInfo({}, surface));
  const std::array wire{*layouts.frame, *layouts.wire};
  const vk::PushConstantRange ink(Stage::eFragment, 0, sizeof(Vec4f));
  layouts.wires = vk::raii::PipelineLayout(vulkan.device, vk::PipelineLayoutCreateInfo({}, wire, ink));
  return layouts;
}

vk::Pipeline DrawPipelines::surface(const SurfaceLook& look) {
  const auto found = surfaces_.find(look);
  if (found != surfaces_.end()) return *found->second;
  const std::array<uint32_t, 6> values{look.shading, look.maps,    look.alpha,
                                       look.unlit,   look.shadows, look.pass == DrawPass::light};
  std::array<vk::SpecializationMapEntry, values.size()> entries;
  for (uint32_t i = 0; i < entries.size(); ++i)
    entries[i] = vk::SpecializationMapEntry(layout::constant_shading + i, 4 * i, 4);
  static_assert(layout::constant_from_light == layout::constant_shading + 5);
  const vk::SpecializationInfo constants(entries.size(), entries.data(), sizeof(values), values.data());
  PipelineParts parts;
  parts.vertex = vertex_shader(look);
  parts.samples = is_depth_only(look.pass) ? vk::SampleCountFlagBits::e1 : samples_;
  parts.colour_format = colour_format_;
  parts.fragment = fragment_shader(look, parts.samples != vk::SampleCountFlagBits::e1);
  parts.constants = &constants;
  const bool positions_only = parts.vertex == Shader::depth_vertex, plain = parts.vertex == Shader::surface_vertex;
  const auto bindings = vertex_bindings(positions_only ? 1 : plain ? 2 : 5);
  const auto attributes = vertex_attributes(positions_only ? 1 : plain ? 3 : 6);
  parts.bindings = bindings;
  parts.attributes = attributes;
  parts.depth = depth_and_blend(look.pass);
  parts.biased = look.pass == DrawPass::light;
  return *surfaces_.emplace(look, create(*vulkan_, *layouts_->surface, parts)).first->second;
}

vk::Pipeline DrawPipelines::floor() {
  if (*floor_) return *floor_;
  PipelineParts parts;
  parts.vertex = Shader::floor_vertex;
  parts.fragment = Shader::floor_fragment;
  parts.topology = vk::PrimitiveTopology::eTriangleStrip;
  parts.samples = samples_;
  parts.colour_format = colour_format_;
  parts.depth = {vk::CompareOp::eLess, false, true, true};
  floor_ = create(*vulkan_, *layouts_->surface, parts);
  return *floor_;
}

vk::Pipeline DrawPipelines::contact() {
  if (*contact_) return *contact_;
  PipelineParts parts;
  parts.vertex = Shader::contact_vertex;
  parts.fragment = Shader::contact_fragment;
  parts.depth = {vk::CompareOp::eAlways, false, true, false};
  parts.colour_format = ShadeMap::format;
  parts.depth_format = vk::Format::eUndefined;
  contact_ = create(*vulkan_, *layouts_->surface, parts);
  return *contact_;
}

vk::Pipeline DrawPipelines::wire(WireDepth depth) {
  const auto found = wires_.find(depth);
  if (found != wires_.end()) return *found->second;
  PipelineParts parts;
  parts.vertex = Shader::wire_vertex;
  parts.fragment = Shader::wire_fragment;
  parts.samples = samples_;
  parts.colour_format = colour_format_;
  const auto compare = depth == WireDepth::tested ? vk::CompareOp::eLess : vk::CompareOp::eAlways;
  parts.depth = {compare, false, true, true};
  return *wires_.emplace(depth, create(*vulkan_, *layouts_->wires, parts)).first->second;
}

}  // namespace sinew
