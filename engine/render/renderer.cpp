#include "engine/render/renderer.h"

#include <cstring>

#include "engine/deform/rigid_split.h"
#include "engine/gpu/shader_code.h"
#include "engine/gpu/target.h"
#include "engine/render/surface.h"

namespace sinew {
namespace {

/// How a pipeline treats what lies behind a surface.
enum class Blending { opaque, over };

vk::raii::Pipeline create_pipeline(VulkanDevice& vulkan, vk::PipelineLayout layout, vk::SampleCountFlagBits samples,
                                   Blending blending) {
  const vk::raii::ShaderModule vertex = vulkan.shader(shader_code(Shader::surface_vertex));
  const vk::raii::ShaderModule fragment = vulkan.shader(shader_code(Shader::surface_fragment));
  const std::array stages{vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eVertex, *vertex, "main"),
                          vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eFragment, *fragment, "main")};
  const std::array bindings{vk::VertexInputBindingDescription(0, layout::words_per_output * 16),
                            vk::VertexInputBindingDescription(1, sizeof(Vec2f))};
  const std::array attributes{vk::VertexInputAttributeDescription(0, 0, vk::Format::eR32G32B32A32Sfloat, 0),
                              vk::VertexInputAttributeDescription(1, 0, vk::Format::eR32G32B32A32Sfloat, 16),
                              vk::VertexInputAttributeDescription(2, 1, vk::Format::eR32G32Sfloat, 0)};
  const vk::PipelineVertexInputStateCreateInfo input({}, bindings, attributes);
  const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleList);
  const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
  vk::PipelineRasterizationStateCreateInfo raster;
  raster.polygonMode = vk::PolygonMode::eFill;
  raster.lineWidth = 1.0f;
  const vk::PipelineMultisampleStateCreateInfo multisample({}, samples);
  const bool opaque = blending == Blending::opaque;
  const vk::PipelineDepthStencilStateCreateInfo depth({}, true, opaque, vk::CompareOp::eLess);
  vk::PipelineColorBlendAttachmentState blend(!opaque, vk::BlendFactor::eSrcAlpha, vk::BlendFactor::eOneMinusSrcAlpha,
                                              vk::BlendOp::eAdd, vk::BlendFactor::eOne,
                                              vk::BlendFactor::eOneMinusSrcAlpha, vk::BlendOp::eAdd);
  using Component = vk::ColorComponentFlagBits;
  blend.colorWriteMask = Component::eR | Component::eG | Component::eB | Component::eA;
  const vk::PipelineColorBlendStateCreateInfo blend_state({}, false, {}, blend);
  const std::array dynamic{vk::DynamicState::eViewport, vk::DynamicState::eScissor, vk::DynamicState::eCullMode,
                           vk::DynamicState::eFrontFace};
  const vk::PipelineDynamicStateCreateInfo dynamic_state({}, dynamic);
  vk::GraphicsPipelineCreateInfo info({}, stages, &input, &assembly, nullptr, &viewport, &raster, &multisample, &depth,
                                      &blend_state, &dynamic_state, layout);
  const vk::PipelineRenderingCreateInfo rendering(0, Target::colour_format, Target::depth_format);
  info.pNext = &rendering;
  return {vulkan.device, nullptr, info};
}

layout::FrameUniforms frame_uniforms(const Shot& shot, double aspect) {
  layout::FrameUniforms u{};
  const Viewpoint& camera = shot.viewpoint;
  u.view_projection = Mat4f(camera.view_projection(aspect));
  u.eye = Vec4f(Vec4(camera.eye, 1.0));
  u.right = Vec4f(Vec4(camera.right, 0.0));
  u.up = Vec4f(Vec4(camera.up, 0.0));
  u.back = Vec4f(Vec4(camera.back, 0.0));
  u.depth_range = Vec4f(Vec4(camera.near_plane, camera.far_plane, shot.largest_bulge, 0.0));
  u.shading = static_cast<uint32_t>(shot.shading);
  return u;
}

static_assert(static_cast<uint32_t>(Shading::lit) == layout::shading_lit);
static_assert(static_cast<uint32_t>(Shading::flat) == layout::shading_flat);
static_assert(static_cast<uint32_t>(Shading::clay) == layout::shading_clay);
static_assert(static_cast<uint32_t>(Shading::normals) == layout::shading_normals);
static_assert(static_cast<uint32_t>(Shading::weights) == layout::shading_weights);
static_assert(static_cast<uint32_t>(Shading::bulge) == layout::shading_bulge);
static_assert(static_cast<uint32_t>(Shading::depth) == layout::shading_depth);

}  // namespace

struct Renderer::Impl {
  struct Character {
    GpuDeformer deformer;
    Surface surface;
  };

  VulkanDevice* vulkan = nullptr;
  Device* device = nullptr;
  Target target;
  Buffer frame_buffer;
  vk::raii::DescriptorSetLayout frame_layout = nullptr, material_layout = nullptr;
  vk::raii::DescriptorPool descriptor_pool = nullptr;
  vk::DescriptorSet frame_set;
  vk::raii::PipelineLayout pipeline_layout = nullptr;
  vk::raii::Pipeline opaque = nullptr, over = nullptr;
  std::vector<Character> characters;

  void create(const RendererOptions& options);
  void set_shot(const Shot& shot) const;
  void record_deform(const vk::raii::CommandBuffer& commands) const;
  void record_draw(const vk::raii::CommandBuffer& commands, const Shot& shot) const;
  void record_parts(const vk::raii::CommandBuffer& commands, bool blended) const;
};

void Renderer::Impl::create(const RendererOptions& options) {
  const vk::raii::Device& d = vulkan->device;
  const auto samples = options.samples == 4 ? vk::SampleCountFlagBits::e4 : vk::SampleCountFlagBits::e1;
  target =
      Target::create(*vulkan, static_cast<uint32_t>(options.width), static_cast<uint32_t>(options.height), samples);
  frame_buffer =
      vulkan->create_buffer(sizeof(layout::FrameUniforms), vk::BufferUsageFlagBits::eUniformBuffer, MemoryUse::upload);
  const auto both = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
  const vk::DescriptorSetLayoutBinding frame_binding(layout::binding_frame, vk::DescriptorType::eUniformBuffer, 1,
                                                     both);
  frame_layout = vk::raii::DescriptorSetLayout(d, vk::DescriptorSetLayoutCreateInfo({}, frame_binding));
  const std::array material_bindings{
      vk::DescriptorSetLayoutBinding(layout::binding_material, vk::DescriptorType::eUniformBuffer, 1, both),
      vk::DescriptorSetLayoutBinding(layout::binding_base_colour, vk::DescriptorType::eCombinedImageSampler, 1, both)};
  material_layout = vk::raii::DescriptorSetLayout(d, vk::DescriptorSetLayoutCreateInfo({}, material_bindings));
  const vk::DescriptorPoolSize size(vk::DescriptorType::eUniformBuffer, 1);
  descriptor_pool = vk::raii::DescriptorPool(d, vk::DescriptorPoolCreateInfo({}, 1, size));
  frame_set =
      (*d).allocateDescriptorSets(vk::DescriptorSetAllocateInfo(*descriptor_pool, *frame_layout), *d.getDispatcher())
          .front();
  const vk::DescriptorBufferInfo whole(*frame_buffer.buffer, 0, VK_WHOLE_SIZE);
  d.updateDescriptorSets(
      vk::WriteDescriptorSet(frame_set, layout::binding_frame, 0, vk::DescriptorType::eUniformBuffer, {}, whole), {});
  const std::array layouts{*frame_layout, *material_layout};
  pipeline_layout = vk::raii::PipelineLayout(d, vk::PipelineLayoutCreateInfo({}, layouts));
  opaque = create_pipeline(*vulkan, *pipeline_layout, samples, Blending::opaque);
  over = create_pipeline(*vulkan, *pipeline_layout, samples, Blending::over);
}

void Renderer::Impl::set_shot(const Shot& shot) const {
  const layout::FrameUniforms uniforms = frame_uniforms(shot, double(target.width) / target.height);
  std::memcpy(frame_buffer.mapped, &uniforms, sizeof(uniforms));
}

void Renderer::Impl::record_deform(const vk::raii::CommandBuffer& commands) const {
  for (const Character& character : characters) character.deformer.impl().record(commands);
}

void Renderer::Impl::record_parts(const vk::raii::CommandBuffer& commands, bool blended) const {
  commands.bindPipeline(vk::PipelineBindPoint::eGraphics, blended ? *over : *opaque);
  commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *pipeline_layout, 0, frame_set, {});
  for (const Character& character : characters) {
    const Surface& surface = character.surface;
    const Buffer& vertices = character.deformer.impl().output;
    commands.bindVertexBuffers(0, {*vertices.buffer, *surface.texture_coordinates.buffer}, {0, 0});
    commands.bindIndexBuffer(*surface.indices.buffer, 0, vk::IndexType::eUint32);
    for (const SurfacePart& part : surface.parts) {
      const SurfaceMaterial& material = surface.materials[part.material];
      if (material.blended != blended || part.index_count == 0) continue;
      commands.setCullMode(material.double_sided ? vk::CullModeFlagBits::eNone : vk::CullModeFlagBits::eBack);
      commands.setFrontFace(part.mirrored ? vk::FrontFace::eClockwise : vk::FrontFace::eCounterClockwise);
      commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *pipeline_layout, 1, material.set, {});
      commands.drawIndexed(part.index_count, 1, part.first_index, 0, 0);
    }
  }
}

void Renderer::Impl::record_draw(const vk::raii::CommandBuffer& commands, const Shot& shot) const {
  target.begin(commands, shot.background);
  record_parts(commands, false);
  record_parts(commands, true);
  target.end(commands);
}

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::create(Device& device, const RendererOptions& options) {
  const vk::PhysicalDeviceLimits& limits = device.vulkan().limits;
  const auto largest =
      static_cast<int>(std::min({limits.maxFramebufferWidth, limits.maxFramebufferHeight, limits.maxImageDimension2D}));
  if (options.width > largest || options.height > largest)
    return bad_input("--size {}x{}: this device makes pictures of up to {}x{}", options.width, options.height, largest,
                     largest);
  const auto counts = limits.framebufferColorSampleCounts & limits.framebufferDepthSampleCounts;
  if (options.samples == 4 && !(counts & vk::SampleCountFlagBits::e4))
    return bad_input("--samples 4: this device draws with 1 sample only");
  auto impl = std::make_unique<Impl>();
  impl->vulkan = &device.vulkan();
  impl->device = &device;
  if (auto ok = vulkan_call("making the picture", [&] { impl->create(options); }); !ok) return pass_on(std::move(ok));
  return Renderer(std::move(impl));
}

Result<void> Renderer::add_character(const Model& model, const CharacterMesh& mesh, const RestShape& rest,
                                     std::span<const PlacedMuscle> muscles, const GpuDeformerOptions& options,
                                     std::vector<std::string>& problems) {
  RigidSplit split;
  if (options.deformer == Deformer::rigid) split = split_by_bone(mesh);
  auto deformer = GpuDeformer::create(*impl_->device, mesh, rest, muscles, options, split.duplicates);
  if (!deformer) return pass_on(std::move(deformer));
  const std::span<const std::uint32_t> triangles =
      options.deformer == Deformer::rigid ? std::span<const std::uint32_t>(split.triangles) : mesh.triangles;
  auto surface = vulkan_call("uploading surfaces", [&] {
    return Surface::create(*impl_->vulkan, model, mesh, triangles, split.duplicates, impl_->material_layout, problems);
  });
  if (!surface) return pass_on(std::move(surface));
  impl_->characters.push_back({std::move(*deformer), std::move(*surface)});
  return {};
}

GpuDeformer& Renderer::deformer(std::size_t character) { return impl_->characters[character].deformer; }

Result<Picture> Renderer::draw(const Shot& shot) {
  auto done = vulkan_call("drawing", [&] {
    impl_->set_shot(shot);
    impl_->vulkan->run([&](vk::raii::CommandBuffer& commands) {
      impl_->record_deform(commands);
      deform_barrier(commands);
      impl_->record_draw(commands, shot);
      impl_->target.record_copy(commands);
    });
  });
  if (!done) return pass_on(std::move(done));
  return picture();
}

Result<void> Renderer::deform() {
  return vulkan_call("deforming", [&] {
    impl_->vulkan->run([&](vk::raii::CommandBuffer& commands) { impl_->record_deform(commands); });
  });
}

Result<void> Renderer::draw_only(const Shot& shot) {
  return vulkan_call("drawing", [&] {
    impl_->set_shot(shot);
    impl_->vulkan->run([&](vk::raii::CommandBuffer& commands) {
      deform_barrier(commands);
      impl_->record_draw(commands, shot);
    });
  });
}

Result<void> Renderer::copy_only() {
  return vulkan_call("reading the picture back", [&] {
    impl_->vulkan->run([&](vk::raii::CommandBuffer& commands) { impl_->target.record_copy(commands); });
  });
}

Picture Renderer::picture() const {
  const Target& target = impl_->target;
  Picture picture{static_cast<int>(target.width), static_cast<int>(target.height), {}};
  const std::span<std::uint8_t> bytes = target.readback.as<std::uint8_t>();
  picture.rgba.assign(bytes.begin(), bytes.begin() + std::ptrdiff_t{4} * picture.width * picture.height);
  return picture;
}

}  // namespace sinew
