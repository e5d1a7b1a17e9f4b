#pragma once
/// Textures on the device. Vulkan types inside: engine/render only.

#include <map>
#include <tuple>

#include "engine/gpu/vulkan.h"
#include "engine/model/model.h"

namespace sinew {

/// What a texture's numbers mean.
enum class TextureContent { colour, data };  ///< sRGB, read as linear; or numbers as they are

/// A model's textures, each image and each way of sampling once.
class TextureSet {
 public:
  TextureSet(VulkanDevice& vulkan, const Model& model) : vulkan_(&vulkan), model_(&model) {}

  /// The image of a texture with all its mipmaps; white where it has none or cannot be decoded, which is then noted in
  /// `problems`, once. Throws vk::SystemError.
  const DeviceImage& image(const Texture& texture, TextureContent content, std::vector<std::string>& problems);

  /// Throws vk::SystemError.
  const vk::raii::Sampler& sampler(const Texture& texture);

 private:
  using SamplerKey = std::tuple<Wrap, Wrap, bool>;

  VulkanDevice* vulkan_;
  const Model* model_;
  std::map<std::pair<int, TextureContent>, DeviceImage> images_;  ///< image -1: white
  std::map<SamplerKey, vk::raii::Sampler> samplers_;
};

}  // namespace sinew
