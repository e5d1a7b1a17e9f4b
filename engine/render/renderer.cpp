#include "engine/render/renderer.h"

#include <cstring>

#include "engine/deform/rigid_split.h"
#include "engine/render/draw_pipelines.h"
#include "engine/render/layers.h"
#include "engine/render/renderer_image.h"
#include "engine/render/shadow_maps.h"
#include "engine/render/studio.h"
#include "engine/render/wire.h"

namespace sinew {
namespace {

/// Seen from below, or along it, the floor shows nothing.
bool is_above(const Viewpoint& camera, double floor) {
  return camera.is_parallel() ? camera.back.y > 1e-6 : camera.eye.y > floor;
}

/// Width of a wire at 720 lines; it grows with the picture.
constexpr double wire_width = 1.1;
/// Dark blue-grey, sRGB and alpha; and what shines through of hidden edges.
const Vec4f wire_ink(0.07f, 0.09f, 0.14f, 0.80f), hidden_wire_ink(0.07f, 0.09f, 0.14f, 0.22f);

Vec4f word(const Vec3& v, double w = 0.0) { return Vec4f(Vec4(v, w)); }

/// The nearest and the farthest distance along the camera's axis of a box's corners.
Vec2 depth_span(const Viewpoint& camera, const Bounds& box) {
  if (box.empty()) return {camera.near_plane, camera.far_plane};
  Vec2 span(std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest());
  for (int i = 0; i < 8; ++i) {
    const double depth = glm::dot(camera.eye - box.corner(i), camera.back);
    span = {std::min(span.x, depth), std::max(span.y, depth)};
  }
  return {span.x, std::max(span.y, span.x + 1e-9)};
}

layout::FrameUniforms frame_uniforms(const Shot& shot, const Target& target, const ShadowMaps& maps) {
  layout::FrameUniforms u{};
  const Viewpoint& camera = shot.viewpoint;
  const double aspect = double(target.width) / target.height;
  const Studio studio = make_studio(camera, aspect, shot.scene, shot.floor.value_or(shot.ground));
  u.view_projection = Mat4f(studio.viewpoint.view_projection(aspect));
  u.light_projection = Mat4f(studio.light_projection);
  u.contact_projection = Mat4f(studio.contact_projection);
  u.eye = camera.is_parallel() ? word(camera.back, 0.0) : word(camera.eye, 1.0);
  u.back = word(camera.back, glm::dot(camera.eye, camera.back));
  u.key = word(studio.key);
  u.fill = word(studio.fill);
  u.rim = word(studio.rim);
  const Vec2 depths = depth_span(camera, shot.scene);
  u.depth_range = word({depths.x, depths.y, shot.largest_bulge});
  u.floor_centre = word(studio.floor_centre, studio.fading_distance);
  u.floor_size = word({studio.floor_half_size.x, studio.floor_half_size.y, 0.0});
  u.shadow = word({studio.shadow_width / maps.light.side, studio.contact_reach, shot.shadows ? 1.0 : 0.0});
  u.picture = word({double(target.width), double(target.height), std::max(wire_width * target.height / 720.0, 1.0)});
  return u;
}

static_assert(static_cast<uint32_t>(Shading::lit) == layout::shading_lit);
static_assert(static_cast<uint32_t>(Shading::flat) == layout::shading_flat);
static_assert(static_cast<uint32_t>(Shading::clay) == layout::shading_clay);
static_assert(static_cast<uint32_t>(Shading::normals) == layout::shading_normals);
static_assert(static_cast<uint32_t>(Shading::weights) == layout::shading_weights);
static_assert(static_cast<uint32_t>(Shading::bulge) == layout::shading_bulge);
static_assert(static_cast<uint32_t>(Shading::depth) == layout::shading_depth);

bool has_materials(Shading shading) { return shading == Shading::lit || shading == Shading::flat; }

/// Whether a part of this material is drawn in a pass.
bool takes_part(DrawPass pass, uint32_t alpha) {
  const bool blended = alpha == layout::alpha_blend;
  if (is_depth_only(pass)) return true;
  return pass == DrawPass::peel || pass == DrawPass::layer || pass == DrawPass::behind ? blended : !blended;
}

}  // namespace

struct Renderer::Impl {
  struct Character {
    GpuDeformer deformer;
    Surface surface;
    std::optional<Wire> wire;
  };

  VulkanDevice* vulkan = nullptr;
  Device* device = nullptr;
  WireMode wire_mode = WireMode::none;
  Target target;
  Buffer frame_buffer;
  DrawLayouts layouts;
  ShadowMaps shadow_maps;
  std::optional<TransparentLayers> layers;  ///< there where a character has anything transparent
  std::optional<DrawPipelines> pipelines;
  vk::raii::DescriptorPool descriptor_pool = nullptr;
  vk::DescriptorSet frame_set;
  vk::DescriptorSet floor_set;  ///< the same, but with the contact map's shade in the map's place
  std::vector<Character> characters;

  void create(const RendererOptions& options);
  void set_size(int width, int height, vk::SampleCountFlagBits samples, vk::Format colour_format);
  void write_frame_set(vk::DescriptorSet set, const vk::DescriptorImageInfo& contact) const;
  void add(const Model& model, const CharacterMesh& mesh, GpuDeformer deformer,
           std::span<const std::uint32_t> triangles, std::span<const RigidDuplicate> duplicates,
           const CharacterLook& look, std::vector<std::string>& problems);
  void set_shot(const Shot& shot) const;
  void record_deform(const vk::raii::CommandBuffer& commands) const;
  void record_shadows(const vk::raii::CommandBuffer& commands, const Shot& shot);
  void record_draw(const vk::raii::CommandBuffer& commands, const Shot& shot);
  void record_parts(const vk::raii::CommandBuffer& commands, DrawPass pass, const Shot& shot,
                    vk::DescriptorSet layer_set = {});
  void record_contact_shade(const vk::raii::CommandBuffer& commands);
  void record_floor(const vk::raii::CommandBuffer& commands);
  void record_wires(const vk::raii::CommandBuffer& commands);
};

void Renderer::Impl::create(const RendererOptions& options) {
  const auto samples = options.samples == 4 ? vk::SampleCountFlagBits::e4 : vk::SampleCountFlagBits::e1;
  wire_mode = options.wire;
  const vk::Format format = options.for_window ? vk::Format::eB8G8R8A8Unorm : vk::Format::eR8G8B8A8Unorm;
  set_size(options.width, options.height, samples, format);
  frame_buffer =
      vulkan->create_buffer(sizeof(layout::FrameUniforms), vk::BufferUsageFlagBits::eUniformBuffer, MemoryUse::upload);
  layouts = DrawLayouts::create(*vulkan);
  shadow_maps = ShadowMaps::create(*vulkan);
  pipelines.emplace(*vulkan, layouts, samples, target.colour_format);
  const std::array sizes{vk::DescriptorPoolSize(vk::DescriptorType::eUniformBuffer, 2),
                         vk::DescriptorPoolSize(vk::DescriptorType::eCombinedImageSampler, 4)};
  descriptor_pool = vk::raii::DescriptorPool(vulkan->device, vk::DescriptorPoolCreateInfo({}, 2, sizes));
  const auto sets = vulkan->allocate_sets(descriptor_pool, std::array{*layouts.frame, *layouts.frame});
  frame_set = sets[0];
  floor_set = sets[1];
  write_frame_set(frame_set,
                  {*shadow_maps.reading, *shadow_maps.contact.image.view, vk::ImageLayout::eDepthReadOnlyOptimal});
  write_frame_set(floor_set,
                  {*shadow_maps.smooth, *shadow_maps.shade.image.view, vk::ImageLayout::eShaderReadOnlyOptimal});
}

void Renderer::Impl::set_size(int width, int height, vk::SampleCountFlagBits samples, vk::Format colour_format) {
  target = Target::create(*vulkan, static_cast<uint32_t>(width), static_cast<uint32_t>(height), samples, colour_format);
  if (layers) layers = TransparentLayers::create(*vulkan, target, layouts.layers);
}

void Renderer::Impl::write_frame_set(vk::DescriptorSet set, const vk::DescriptorImageInfo& contact) const {
  const vk::DescriptorBufferInfo numbers(*frame_buffer.buffer, 0, VK_WHOLE_SIZE);
  const vk::DescriptorImageInfo light(*shadow_maps.comparing, *shadow_maps.light.image.view,
                                      vk::ImageLayout::eDepthReadOnlyOptimal);
  vulkan->device.updateDescriptorSets(
      {{set, layout::binding_frame, 0, vk::DescriptorType::eUniformBuffer, {}, numbers},
       {set, layout::binding_shadow_map, 0, vk::DescriptorType::eCombinedImageSampler, light},
       {set, layout::binding_contact_map, 0, vk::DescriptorType::eCombinedImageSampler, contact}},
      {});
}

void Renderer::Impl::add(const Model& model, const CharacterMesh& mesh, GpuDeformer deformer,
                         std::span<const std::uint32_t> triangles, std::span<const RigidDuplicate> duplicates,
                         const CharacterLook& look, std::vector<std::string>& problems) {
  Surface surface =
      Surface::create(*vulkan, {model, mesh, triangles, duplicates, look.weights}, layouts.material, problems);
  if (surface.blended && !layers) layers = TransparentLayers::create(*vulkan, target, layouts.layers);
  std::optional<Wire> wire;
  const Buffer& vertices = deformer.impl().output;
  if (wire_mode != WireMode::none && vertices.size <= vulkan->limits.maxStorageBufferRange)
    wire = Wire::create(*vulkan, triangles, vertices, layouts.wire);
  else if (wire_mode != WireMode::none)
    problems.push_back("the mesh is too large for this device to draw its edges");
  characters.push_back({std::move(deformer), std::move(surface), std::move(wire)});
}

void Renderer::Impl::set_shot(const Shot& shot) const {
  const layout::FrameUniforms uniforms = frame_uniforms(shot, target, shadow_maps);
  std::memcpy(frame_buffer.mapped, &uniforms, sizeof(uniforms));
}

void Renderer::Impl::record_deform(const vk::raii::CommandBuffer& commands) const {
  for (const Character& character : characters) character.deformer.impl().record(commands);
}

void Renderer::Impl::record_shadows(const vk::raii::CommandBuffer& commands, const Shot& shot) {
  if (!has_materials(shot.shading)) return;
  if (shot.shadows) {
    shadow_maps.light.begin(commands);
    record_parts(commands, DrawPass::light, shot);
    shadow_maps.light.end(commands);
  }
  if (shot.floor) {
    shadow_maps.contact.begin(commands);
    record_parts(commands, DrawPass::below, shot);
    shadow_maps.contact.end(commands);
    record_contact_shade(commands);
  }
}

void Renderer::Impl::record_parts(const vk::raii::CommandBuffer& commands, DrawPass pass, const Shot& shot,
                                  vk::DescriptorSet layer_set) {
  constexpr auto graphics = vk::PipelineBindPoint::eGraphics;
  const bool depth_only = is_depth_only(pass);
  commands.bindDescriptorSets(graphics, *layouts.surface, 0, frame_set, {});
  if (layer_set) commands.bindDescriptorSets(graphics, *layouts.surface, 2, layer_set, {});
  for (const Character& character : characters) {
    const Surface& surface = character.surface;
    const GpuDeformer::Impl& deformer = character.deformer.impl();
    std::vector<vk::Buffer> streams{*deformer.output.buffer, *surface.texture_coordinates.buffer};
    if (*surface.colours.buffer) {
      // Where there are no tangents no shader reads them; the stream has to be there.
      const Buffer& tangents = deformer.has_tangents ? deformer.output_tangents : surface.colours;
      streams.insert(streams.end(),
                     {*tangents.buffer, *surface.second_texture_coordinates.buffer, *surface.colours.buffer});
    }
    commands.bindVertexBuffers(0, streams, std::vector<vk::DeviceSize>(streams.size(), 0));
    commands.bindIndexBuffer(*surface.indices.buffer, 0, vk::IndexType::eUint32);
    for (const SurfacePart& part : surface.parts) {
      const SurfaceMaterial& material = surface.material(part);
      if (!takes_part(pass, material.alpha)) continue;
      SurfaceLook look{pass, 0, material.maps, material.alpha, material.unlit, false, material.rich};
      // What blends throws a shadow where it is more there than not.
      if (depth_only && material.alpha == layout::alpha_blend) look.alpha = layout::alpha_mask;
      if (!depth_only) {
        look.shading = static_cast<uint32_t>(shot.shading);
        look.shadows = shot.shadows && has_materials(shot.shading);
      }
      commands.bindPipeline(graphics, pipelines->surface(look));
      // A light is not asked which side of a sheet it sees.
      const bool both_sides = material.double_sided || depth_only;
      commands.setCullMode(both_sides ? vk::CullModeFlagBits::eNone : vk::CullModeFlagBits::eBack);
      commands.setFrontFace(part.mirrored ? vk::FrontFace::eClockwise : vk::FrontFace::eCounterClockwise);
      commands.bindDescriptorSets(graphics, *layouts.surface, 1, material.set, {});
      commands.drawIndexed(part.index_count, 1, part.first_index, 0, 0);
    }
  }
}

void Renderer::Impl::record_contact_shade(const vk::raii::CommandBuffer& commands) {
  shadow_maps.shade.begin(commands);
  commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipelines->contact());
  commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layouts.surface, 0, frame_set, {});
  commands.setCullMode(vk::CullModeFlagBits::eNone);
  commands.setFrontFace(vk::FrontFace::eCounterClockwise);
  commands.draw(3, 1, 0, 0);
  shadow_maps.shade.end(commands);
}

void Renderer::Impl::record_floor(const vk::raii::CommandBuffer& commands) {
  commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipelines->floor());
  commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layouts.surface, 0, floor_set, {});
  commands.setCullMode(vk::CullModeFlagBits::eNone);
  commands.setFrontFace(vk::FrontFace::eCounterClockwise);
  commands.draw(4, 1, 0, 0);
}

void Renderer::Impl::record_wires(const vk::raii::CommandBuffer& commands) {
  const auto record = [&](WireDepth depth, const Vec4f& ink) {
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipelines->wire(depth));
    commands.pushConstants<Vec4f>(*layouts.wires, vk::ShaderStageFlagBits::eFragment, 0, ink);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layouts.wires, 0, frame_set, {});
    commands.setCullMode(vk::CullModeFlagBits::eNone);
    commands.setFrontFace(vk::FrontFace::eCounterClockwise);
    for (const Character& character : characters) {
      if (!character.wire) continue;
      commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layouts.wires, 1, character.wire->set, {});
      commands.draw(6 * character.wire->edge_count, 1, 0, 0);
    }
  };
  if (wire_mode == WireMode::all) record(WireDepth::through, hidden_wire_ink);
  record(WireDepth::tested, wire_ink);
}

void Renderer::Impl::record_draw(const vk::raii::CommandBuffer& commands, const Shot& shot) {
  record_shadows(commands, shot);
  target.begin(commands, shot.background, !layers);
  record_parts(commands, DrawPass::opaque, shot);
  if (shot.floor && has_materials(shot.shading) && is_above(shot.viewpoint, *shot.floor)) record_floor(commands);
  if (wire_mode != WireMode::none) record_wires(commands);
  target.end(commands);
  if (!layers) return;
  layers->record(commands, target,
                 [&](DrawPass pass, vk::DescriptorSet set) { record_parts(commands, pass, shot, set); });
}

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

namespace {

Result<void> check_size(const vk::PhysicalDeviceLimits& limits, int width, int height) {
  const auto largest =
      static_cast<int>(std::min({limits.maxFramebufferWidth, limits.maxFramebufferHeight, limits.maxImageDimension2D}));
  if (width <= largest && height <= largest) return {};
  return bad_input("--size {}x{}: this device makes pictures of up to {}x{}", width, height, largest, largest);
}

}  // namespace

Result<Renderer> Renderer::create(Device& device, const RendererOptions& options) {
  const vk::PhysicalDeviceLimits& limits = device.vulkan().limits;
  if (auto ok = check_size(limits, options.width, options.height); !ok) return pass_on(std::move(ok));
  const auto counts = limits.framebufferColorSampleCounts & limits.framebufferDepthSampleCounts;
  if (options.samples == 4 && (!(counts & vk::SampleCountFlagBits::e4) || !device.vulkan().sample_shading))
    return bad_input("--samples 4: this device draws with 1 sample only");
  auto impl = std::make_unique<Impl>();
  impl->vulkan = &device.vulkan();
  impl->device = &device;
  if (auto ok = vulkan_call("making the picture", [&] { impl->create(options); }); !ok) return pass_on(std::move(ok));
  return Renderer(std::move(impl));
}

Result<void> Renderer::add_character(const Model& model, const CharacterMesh& mesh, const RestShape& rest,
                                     std::span<const PlacedMuscle> muscles, const GpuDeformerOptions& options,
                                     const CharacterLook& look, std::vector<std::string>& problems) {
  RigidSplit split;
  if (options.deformer == Deformer::rigid) split = split_by_bone(mesh);
  auto deformer = GpuDeformer::create(*impl_->device, mesh, rest, muscles, options, split.duplicates);
  if (!deformer) return pass_on(std::move(deformer));
  const std::span<const std::uint32_t> triangles =
      options.deformer == Deformer::rigid ? std::span<const std::uint32_t>(split.triangles) : mesh.triangles;
  return vulkan_call("uploading surfaces", [&] {
    impl_->add(model, mesh, std::move(*deformer), triangles, split.duplicates, look, problems);
  });
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

Result<void> Renderer::draw_for_window(const Shot& shot) {
  return vulkan_call("drawing", [&] {
    impl_->set_shot(shot);
    impl_->vulkan->run([&](vk::raii::CommandBuffer& commands) {
      impl_->record_deform(commands);
      deform_barrier(commands);
      impl_->record_draw(commands, shot);
      make_colour_copyable(commands, impl_->target.colour);
    });
  });
}

Result<void> Renderer::resize(int width, int height) {
  if (auto ok = check_size(impl_->vulkan->limits, width, height); !ok) return ok;
  return vulkan_call("making the picture",
                     [&] { impl_->set_size(width, height, impl_->target.samples, impl_->target.colour_format); });
}

const Target& picture_target(const Renderer& renderer) { return renderer.impl_->target; }

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
  if (target.colour_format == vk::Format::eB8G8R8A8Unorm)
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) std::swap(picture.rgba[i], picture.rgba[i + 2]);
  return picture;
}

}  // namespace sinew
