#include "engine/render/surface.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace sinew {
namespace {

/// Reflectance of glass, plastic and skin at normal incidence: index of refraction 1.5.
constexpr double dielectric_reflectance = 0.04;

/// A material's textures by their binding, each with its bit of constant_maps.
struct Slot {
  const Texture& texture;
  uint32_t map = 0;
  TextureContent content = TextureContent::data;
};

std::array<Slot, layout::texture_count> slots(const Material& m) {
  return {Slot{m.base_colour_texture, layout::map_base_colour, TextureContent::colour},
          Slot{m.metallic_roughness_texture, layout::map_metallic_roughness},
          Slot{m.normal_texture, layout::map_normal}, Slot{m.occlusion_texture, layout::map_occlusion},
          Slot{m.emissive_texture, layout::map_emissive, TextureContent::colour}};
}

layout::TexturePlace place_of(const Texture& texture) {
  const glm::dmat2 m = texture.turn_and_scale();
  return {Vec4f(Vec4(m[0][0], m[1][0], texture.offset.x, texture.coordinates)),
          Vec4f(Vec4(m[0][1], m[1][1], texture.offset.y, 0.0))};
}

layout::MaterialUniforms uniforms(const Material& m) {
  layout::MaterialUniforms result{};
  result.base_colour = Vec4f(m.base_colour);
  result.surface = Vec4f(Vec4(m.metallic, m.roughness, m.normal_scale, m.occlusion_strength));
  result.emissive = Vec4f(Vec4(m.emissive, m.alpha_cutoff));
  result.specular = Vec4f(Vec4(glm::min(dielectric_reflectance * m.specular_colour, 1.0) * m.specular, 0.0));
  const auto textures = slots(m);
  for (std::size_t i = 0; i < textures.size(); ++i) result.places[i] = place_of(textures[i].texture);
  return result;
}

uint32_t alpha_of(AlphaMode mode) {
  switch (mode) {
    case AlphaMode::opaque:
      return layout::alpha_opaque;
    case AlphaMode::mask:
      return layout::alpha_mask;
    case AlphaMode::blend:
      return layout::alpha_blend;
  }
  return layout::alpha_opaque;
}

SurfaceMaterial look_of(const Material& material, bool has_colours) {
  SurfaceMaterial look;
  bool second = false;
  for (const Slot& slot : slots(material)) {
    if (!slot.texture.there()) continue;
    look.maps |= slot.map;
    if (slot.texture.transformed() || slot.texture.coordinates != 0) look.maps |= layout::map_transform;
    second = second || slot.texture.coordinates != 0;
  }
  if (has_colours) look.maps |= layout::map_colours;
  look.alpha = alpha_of(material.alpha_mode);
  look.unlit = material.unlit;
  look.double_sided = material.double_sided;
  constexpr uint32_t plain = layout::map_base_colour | layout::map_transform;
  look.rich = second || (look.maps & ~plain) != 0 || look.alpha == layout::alpha_blend;
  return look;
}

/// Fills a buffer that vertices are fetched from; `duplicates` repeat what their vertex has.
template <class To, class From>
Buffer vertex_buffer(VulkanDevice& vulkan, const From& values, std::span<const RigidDuplicate> duplicates) {
  std::vector<To> all(values.begin(), values.end());
  for (const RigidDuplicate& duplicate : duplicates) all.push_back(all[duplicate.vertex]);
  const auto bytes = std::as_bytes(std::span(all));
  Buffer buffer = vulkan.create_buffer(bytes.size(), vk::BufferUsageFlagBits::eVertexBuffer, MemoryUse::device);
  vulkan.upload(buffer, bytes);
  return buffer;
}

void create_rich_vertices(VulkanDevice& vulkan, const SurfaceContent& content, Surface& surface) {
  const CharacterMesh& mesh = content.mesh;
  std::vector<Vec2> second = mesh.second_texture_coordinates;
  second.resize(mesh.vertices(), Vec2(0.0));
  surface.second_texture_coordinates = vertex_buffer<Vec2f>(vulkan, second, content.duplicates);
  std::vector<Vec4> colours = mesh.colours;
  if (!content.weights.empty()) {
    colours.clear();
    for (const double weight : content.weights) colours.emplace_back(weight, 0.0, 0.0, 1.0);
  }
  colours.resize(mesh.vertices(), Vec4(1.0));
  surface.colours = vertex_buffer<Vec4f>(vulkan, colours, content.duplicates);
}

/// The model's materials, and last what a primitive without a material gets: a mid-grey that shows form.
std::vector<Material> all_materials(const Model& model) {
  std::vector<Material> materials = model.materials;
  Material& plain = materials.emplace_back();
  plain.base_colour = Vec4(0.60, 0.58, 0.56, 1.0);
  plain.double_sided = true;
  return materials;
}

void write_set(VulkanDevice& vulkan, vk::DescriptorSet set, const vk::DescriptorBufferInfo& numbers,
               const Material& material, TextureSet& textures, std::vector<std::string>& problems) {
  std::array<vk::DescriptorImageInfo, layout::texture_count> images;
  std::vector<vk::WriteDescriptorSet> writes{
      {set, layout::binding_material, 0, vk::DescriptorType::eUniformBuffer, {}, numbers}};
  const auto all = slots(material);
  for (uint32_t i = 0; i < layout::texture_count; ++i) {
    images[i] = {*textures.sampler(all[i].texture), *textures.image(all[i].texture, all[i].content, problems).view,
                 vk::ImageLayout::eShaderReadOnlyOptimal};
    writes.emplace_back(set, layout::binding_base_colour + i, 0, vk::DescriptorType::eCombinedImageSampler, images[i]);
  }
  vulkan.device.updateDescriptorSets(writes, {});
}

void create_materials(VulkanDevice& vulkan, const SurfaceContent& content,
                      const vk::DescriptorSetLayout& material_layout, Surface& surface,
                      std::vector<std::string>& problems) {
  const std::vector<Material> materials = all_materials(content.model);
  const auto count = static_cast<uint32_t>(materials.size());
  const std::array sizes{
      vk::DescriptorPoolSize(vk::DescriptorType::eUniformBuffer, count),
      vk::DescriptorPoolSize(vk::DescriptorType::eCombinedImageSampler, count * layout::texture_count)};
  surface.descriptor_pool = vk::raii::DescriptorPool(vulkan.device, vk::DescriptorPoolCreateInfo({}, count, sizes));
  surface.textures.emplace(vulkan, content.model);

  const vk::DeviceSize alignment = std::max<vk::DeviceSize>(vulkan.limits.minUniformBufferOffsetAlignment, 1);
  const vk::DeviceSize stride = (sizeof(layout::MaterialUniforms) + alignment - 1) / alignment * alignment;
  surface.material_uniforms =
      vulkan.create_buffer(stride * count, vk::BufferUsageFlagBits::eUniformBuffer, MemoryUse::upload);
  for (uint32_t i = 0; i < count; ++i) {
    const layout::MaterialUniforms words = uniforms(materials[i]);
    std::memcpy(static_cast<std::byte*>(surface.material_uniforms.mapped) + i * stride, &words, sizeof(words));
    SurfaceMaterial look = look_of(materials[i], !content.mesh.colours.empty());
    look.set = vulkan.allocate_sets(surface.descriptor_pool, std::array{material_layout}).front();
    write_set(vulkan, look.set, {*surface.material_uniforms.buffer, i * stride, sizeof(words)}, materials[i],
              *surface.textures, problems);
    if (!content.weights.empty()) look.rich = true;
    surface.materials.push_back(look);
  }
}

}  // namespace

vk::raii::DescriptorSetLayout create_material_layout(VulkanDevice& vulkan) {
  const auto both = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
  std::vector<vk::DescriptorSetLayoutBinding> bindings{
      {layout::binding_material, vk::DescriptorType::eUniformBuffer, 1, both}};
  for (uint32_t i = 0; i < layout::texture_count; ++i)
    bindings.emplace_back(layout::binding_base_colour + i, vk::DescriptorType::eCombinedImageSampler, 1,
                          vk::ShaderStageFlagBits::eFragment);
  return {vulkan.device, vk::DescriptorSetLayoutCreateInfo({}, bindings)};
}

Surface Surface::create(VulkanDevice& vulkan, const SurfaceContent& content,
                        const vk::raii::DescriptorSetLayout& material_layout, std::vector<std::string>& problems) {
  Surface surface;
  const CharacterMesh& mesh = content.mesh;
  surface.texture_coordinates = vertex_buffer<Vec2f>(vulkan, mesh.texture_coordinates, content.duplicates);
  surface.indices =
      vulkan.create_buffer(content.triangles.size_bytes(), vk::BufferUsageFlagBits::eIndexBuffer, MemoryUse::device);
  vulkan.upload(surface.indices, std::as_bytes(content.triangles));
  create_materials(vulkan, content, *material_layout, surface, problems);

  bool rich = false;
  for (const MeshPart& part : mesh.parts) {
    if (part.index_count == 0) continue;
    const std::size_t material =
        part.material >= 0 ? static_cast<std::size_t>(part.material) : content.model.materials.size();
    surface.parts.push_back({part.first_index, part.index_count, material, part.mirrored});
    const SurfaceMaterial& look = surface.materials[material];
    surface.blended = surface.blended || look.alpha == layout::alpha_blend;
    rich = rich || look.rich || look.alpha != layout::alpha_opaque;
  }
  if (rich) create_rich_vertices(vulkan, content, surface);
  return surface;
}

}  // namespace sinew
