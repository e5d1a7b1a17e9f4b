#include "engine/render/surface.h"

#include <algorithm>
#include <cstring>

#include "engine/io/image.h"
#include "engine/model/picture.h"

namespace sinew {
namespace {

constexpr vk::Format texture_format = vk::Format::eR8G8B8A8Unorm;

/// Halves a picture in both directions, a pixel being the mean of the up to four that it covers.
Picture halved(const Picture& large) {
  Picture small{std::max(large.width / 2, 1), std::max(large.height / 2, 1), {}};
  small.rgba.resize(std::size_t{4} * small.width * small.height);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x)
      for (int c = 0; c < 4; ++c) {
        const int x1 = std::min(2 * x + 1, large.width - 1), y1 = std::min(2 * y + 1, large.height - 1);
        const auto at = [&](int px, int py) { return large.rgba[(std::size_t(py) * large.width + px) * 4 + c]; };
        const int sum = at(std::min(2 * x, x1), std::min(2 * y, y1)) + at(x1, std::min(2 * y, y1)) +
                        at(std::min(2 * x, x1), y1) + at(x1, y1);
        small.rgba[(std::size_t(y) * small.width + x) * 4 + c] = static_cast<std::uint8_t>((sum + 2) / 4);
      }
  return small;
}

std::vector<Picture> mip_chain(Picture picture) {
  std::vector<Picture> levels;
  levels.push_back(std::move(picture));
  while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(halved(levels.back()));
  return levels;
}

DeviceImage upload_texture(VulkanDevice& vulkan, const std::vector<Picture>& levels) {
  using Usage = vk::ImageUsageFlagBits;
  const auto width = static_cast<uint32_t>(levels[0].width), height = static_cast<uint32_t>(levels[0].height);
  const auto count = static_cast<uint32_t>(levels.size());
  DeviceImage image =
      vulkan.create_image(vk::ImageCreateInfo({}, vk::ImageType::e2D, texture_format, vk::Extent3D(width, height, 1),
                                              count, 1, vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal,
                                              Usage::eSampled | Usage::eTransferDst),
                          vk::ImageAspectFlagBits::eColor);
  std::vector<std::uint8_t> bytes;
  std::vector<vk::BufferImageCopy> copies;
  for (uint32_t level = 0; level < count; ++level) {
    const Picture& p = levels[level];
    copies.emplace_back(bytes.size(), 0, 0, vk::ImageSubresourceLayers(vk::ImageAspectFlagBits::eColor, level, 0, 1),
                        vk::Offset3D(), vk::Extent3D(uint32_t(p.width), uint32_t(p.height), 1));
    bytes.insert(bytes.end(), p.rgba.begin(), p.rgba.end());
  }
  const Buffer staging = vulkan.create_buffer(bytes.size(), vk::BufferUsageFlagBits::eTransferSrc, MemoryUse::upload);
  vulkan.upload(staging, std::as_bytes(std::span(bytes)));
  vulkan.run([&](vk::raii::CommandBuffer& commands) {
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    using Layout = vk::ImageLayout;
    const vk::ImageSubresourceRange whole(vk::ImageAspectFlagBits::eColor, 0, count, 0, 1);
    const auto to = [&](Stage from_stage, Access from_access, Stage stage, Access access, Layout before, Layout after) {
      const vk::ImageMemoryBarrier2 barrier(from_stage, from_access, stage, access, before, after,
                                            VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, *image.image, whole);
      commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barrier));
    };
    to(Stage::eNone, Access::eNone, Stage::eCopy, Access::eTransferWrite, Layout::eUndefined,
       Layout::eTransferDstOptimal);
    commands.copyBufferToImage(*staging.buffer, *image.image, Layout::eTransferDstOptimal, copies);
    to(Stage::eCopy, Access::eTransferWrite, Stage::eFragmentShader, Access::eShaderSampledRead,
       Layout::eTransferDstOptimal, Layout::eShaderReadOnlyOptimal);
  });
  return image;
}

vk::SamplerAddressMode address_mode(Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return vk::SamplerAddressMode::eRepeat;
    case Wrap::clamp:
      return vk::SamplerAddressMode::eClampToEdge;
    case Wrap::mirror:
      return vk::SamplerAddressMode::eMirroredRepeat;
  }
  return vk::SamplerAddressMode::eRepeat;
}

vk::raii::Sampler create_sampler(VulkanDevice& vulkan, const Material& material) {
  const vk::Filter filter = material.nearest_filter ? vk::Filter::eNearest : vk::Filter::eLinear;
  vk::SamplerCreateInfo info({}, filter, filter, vk::SamplerMipmapMode::eLinear, address_mode(material.wrap_u),
                             address_mode(material.wrap_v));
  info.maxLod = VK_LOD_CLAMP_NONE;
  info.anisotropyEnable = vulkan.anisotropy && !material.nearest_filter;
  info.maxAnisotropy = std::min(8.0f, vulkan.limits.maxSamplerAnisotropy);
  return {vulkan.device, info};
}

/// The material's texture, or white.
Picture base_colour_picture(const Model& model, const Material& material, std::vector<std::string>& problems) {
  const Picture white{1, 1, {255, 255, 255, 255}};
  if (material.base_colour_image < 0) return white;
  const EncodedImage& encoded = model.images[material.base_colour_image];
  if (encoded.bytes.empty()) return white;
  auto decoded = decode_image(encoded.bytes);
  if (!decoded) {
    problems.push_back(
        fmt::format("images/{}: {}; shown as white", material.base_colour_image, decoded.error().message));
    return white;
  }
  return std::move(*decoded);
}

layout::MaterialUniforms uniforms(const Material& material) {
  layout::MaterialUniforms result{};
  result.base_colour = Vec4f(material.base_colour);
  result.alpha_cutoff = material.alpha_mode == AlphaMode::mask ? static_cast<float>(material.alpha_cutoff) : -1.0f;
  result.opaque = material.alpha_mode == AlphaMode::blend ? 0.0f : 1.0f;
  return result;
}

void create_materials(VulkanDevice& vulkan, const Model& model, const vk::raii::DescriptorSetLayout& material_layout,
                      Surface& surface, std::vector<std::string>& problems) {
  std::vector<Material> materials = model.materials;
  // The last one is what a primitive without a material gets: a mid-grey that shows form.
  Material& plain = materials.emplace_back();
  plain.base_colour = Vec4(0.60, 0.58, 0.56, 1.0);
  plain.double_sided = true;
  const auto count = static_cast<uint32_t>(materials.size());
  const std::array sizes{vk::DescriptorPoolSize(vk::DescriptorType::eUniformBuffer, count),
                         vk::DescriptorPoolSize(vk::DescriptorType::eCombinedImageSampler, count)};
  surface.descriptor_pool = vk::raii::DescriptorPool(vulkan.device, vk::DescriptorPoolCreateInfo({}, count, sizes));

  const vk::DeviceSize alignment = std::max<vk::DeviceSize>(vulkan.limits.minUniformBufferOffsetAlignment, 1);
  const vk::DeviceSize stride = (sizeof(layout::MaterialUniforms) + alignment - 1) / alignment * alignment;
  surface.material_uniforms =
      vulkan.create_buffer(stride * count, vk::BufferUsageFlagBits::eUniformBuffer, MemoryUse::upload);
  for (uint32_t i = 0; i < count; ++i) {
    const layout::MaterialUniforms words = uniforms(materials[i]);
    std::memcpy(static_cast<std::byte*>(surface.material_uniforms.mapped) + i * stride, &words, sizeof(words));
    SurfaceTexture& texture = surface.textures.emplace_back();
    texture.image = upload_texture(vulkan, mip_chain(base_colour_picture(model, materials[i], problems)));
    texture.sampler = create_sampler(vulkan, materials[i]);

    const vk::DescriptorSetAllocateInfo allocate(*surface.descriptor_pool, *material_layout);
    const vk::DescriptorSet set =
        (*vulkan.device).allocateDescriptorSets(allocate, *vulkan.device.getDispatcher()).front();
    const vk::DescriptorBufferInfo buffer(*surface.material_uniforms.buffer, i * stride, sizeof(words));
    const vk::DescriptorImageInfo image(*texture.sampler, *texture.image.view, vk::ImageLayout::eShaderReadOnlyOptimal);
    vulkan.device.updateDescriptorSets(
        {vk::WriteDescriptorSet(set, layout::binding_material, 0, vk::DescriptorType::eUniformBuffer, {}, buffer),
         vk::WriteDescriptorSet(set, layout::binding_base_colour, 0, vk::DescriptorType::eCombinedImageSampler, image)},
        {});
    surface.materials.push_back({set, materials[i].double_sided, materials[i].alpha_mode == AlphaMode::blend});
  }
}

}  // namespace

Surface Surface::create(VulkanDevice& vulkan, const Model& model, const CharacterMesh& mesh,
                        std::span<const std::uint32_t> triangles, std::span<const RigidDuplicate> duplicates,
                        const vk::raii::DescriptorSetLayout& material_layout, std::vector<std::string>& problems) {
  using Usage = vk::BufferUsageFlagBits;
  Surface surface;
  std::vector<Vec2f> coordinates(mesh.texture_coordinates.begin(), mesh.texture_coordinates.end());
  for (const RigidDuplicate& duplicate : duplicates) coordinates.push_back(coordinates[duplicate.vertex]);
  surface.texture_coordinates =
      vulkan.create_buffer(std::as_bytes(std::span(coordinates)).size(), Usage::eVertexBuffer, MemoryUse::device);
  vulkan.upload(surface.texture_coordinates, std::as_bytes(std::span(coordinates)));
  surface.indices = vulkan.create_buffer(triangles.size_bytes(), Usage::eIndexBuffer, MemoryUse::device);
  vulkan.upload(surface.indices, std::as_bytes(triangles));

  create_materials(vulkan, model, material_layout, surface, problems);
  for (const MeshPart& part : mesh.parts) {
    const std::size_t material = part.material >= 0 ? static_cast<std::size_t>(part.material) : model.materials.size();
    surface.parts.push_back({part.first_index, part.index_count, material, part.mirrored});
  }
  std::stable_partition(surface.parts.begin(), surface.parts.end(),
                        [&](const SurfacePart& part) { return !surface.materials[part.material].blended; });
  return surface;
}

}  // namespace sinew
