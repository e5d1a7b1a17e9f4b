#include "engine/render/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/io/image.h"
#include "engine/model/picture.h"

namespace sinew {
namespace {

/// sRGB numbers as linear light, IEC 61966-2-1.
std::array<double, 256> linear_of_srgb() {
  std::array<double, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i) {
    const double c = static_cast<double>(i) / 255.0;
    linear[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return linear;
}

std::uint8_t srgb_of_linear(double c) {
  const double s = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::clamp(std::lround(255.0 * s), 0l, 255l));
}

/// Halves a picture in both directions, a pixel being the mean of the up to four that it covers; of colours the mean
/// of their light.
Picture halved(const Picture& large, TextureContent content) {
  static const std::array<double, 256> linear = linear_of_srgb();
  Picture small{std::max(large.width / 2, 1), std::max(large.height / 2, 1), {}};
  small.rgba.resize(std::size_t{4} * small.width * small.height);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x)
      for (int c = 0; c < 4; ++c) {
        const int x1 = std::min(2 * x + 1, large.width - 1), y1 = std::min(2 * y + 1, large.height - 1);
        const auto at = [&](int px, int py) { return large.rgba[(std::size_t(py) * large.width + px) * 4 + c]; };
        const std::uint8_t four[] = {at(std::min(2 * x, x1), std::min(2 * y, y1)), at(x1, std::min(2 * y, y1)),
                                     at(std::min(2 * x, x1), y1), at(x1, y1)};
        std::uint8_t& mean = small.rgba[(std::size_t(y) * small.width + x) * 4 + c];
        if (content == TextureContent::colour && c < 3)
          mean = srgb_of_linear(0.25 * (linear[four[0]] + linear[four[1]] + linear[four[2]] + linear[four[3]]));
        else
          mean = static_cast<std::uint8_t>((four[0] + four[1] + four[2] + four[3] + 2) / 4);
      }
  return small;
}

std::vector<Picture> mip_chain(Picture picture, TextureContent content) {
  std::vector<Picture> levels;
  levels.push_back(std::move(picture));
  while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(halved(levels.back(), content));
  return levels;
}

DeviceImage upload_texture(VulkanDevice& vulkan, const std::vector<Picture>& levels, vk::Format format) {
  using Usage = vk::ImageUsageFlagBits;
  const auto width = static_cast<uint32_t>(levels[0].width), height = static_cast<uint32_t>(levels[0].height);
  const auto count = static_cast<uint32_t>(levels.size());
  DeviceImage image =
      vulkan.create_image(vk::ImageCreateInfo({}, vk::ImageType::e2D, format, vk::Extent3D(width, height, 1), count, 1,
                                              vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal,
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

Picture decoded_or_white(const Model& model, int index, std::vector<std::string>& problems) {
  const Picture white{1, 1, {255, 255, 255, 255}};
  if (index < 0) return white;
  const EncodedImage& encoded = model.images[index];
  if (encoded.bytes.empty()) return white;
  auto decoded = decode_image(encoded.bytes);
  if (decoded) return std::move(*decoded);
  problems.push_back(fmt::format("images/{}: {}; shown as white", index, decoded.error().message));
  return white;
}

}  // namespace

const DeviceImage& TextureSet::image(const Texture& texture, TextureContent content,
                                     std::vector<std::string>& problems) {
  const auto found = images_.find({texture.image, content});
  if (found != images_.end()) return found->second;
  const vk::Format format = content == TextureContent::colour ? vk::Format::eR8G8B8A8Srgb : vk::Format::eR8G8B8A8Unorm;
  const auto levels = mip_chain(decoded_or_white(*model_, texture.image, problems), content);
  return images_.emplace(std::pair(texture.image, content), upload_texture(*vulkan_, levels, format)).first->second;
}

const vk::raii::Sampler& TextureSet::sampler(const Texture& texture) {
  const SamplerKey key{texture.wrap_u, texture.wrap_v, texture.nearest_filter};
  const auto found = samplers_.find(key);
  if (found != samplers_.end()) return found->second;
  const vk::Filter filter = texture.nearest_filter ? vk::Filter::eNearest : vk::Filter::eLinear;
  vk::SamplerCreateInfo info({}, filter, filter, vk::SamplerMipmapMode::eLinear, address_mode(texture.wrap_u),
                             address_mode(texture.wrap_v));
  info.maxLod = VK_LOD_CLAMP_NONE;
  info.anisotropyEnable = vulkan_->anisotropy && !texture.nearest_filter;
  info.maxAnisotropy = std::min(8.0f, vulkan_->limits.maxSamplerAnisotropy);
  return samplers_.emplace(key, vk::raii::Sampler(vulkan_->device, info)).first->second;
}

}  // namespace sinew
