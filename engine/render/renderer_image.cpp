#include "engine/render/renderer_image.h"

namespace sinew {

Result<void> put_picture(VulkanDevice& vulkan, const Renderer& renderer, const Picture& picture) {
  return vulkan_call("showing the picture", [&] {
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    using Layout = vk::ImageLayout;
    const Buffer staging =
        vulkan.create_buffer(picture.rgba.size(), vk::BufferUsageFlagBits::eTransferSrc, MemoryUse::upload);
    const std::span<std::uint8_t> bytes = staging.as<std::uint8_t>();
    std::ranges::copy(picture.rgba, bytes.begin());
    if (picture_target(renderer).colour_format == vk::Format::eB8G8R8A8Unorm)
      for (std::size_t i = 0; i < picture.rgba.size(); i += 4) std::swap(bytes[i], bytes[i + 2]);
    const vk::Image image = *picture_image(renderer).image;
    const vk::ImageSubresourceRange whole(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
    const vk::ImageSubresourceLayers layers(vk::ImageAspectFlagBits::eColor, 0, 0, 1);
    vulkan.run([&](vk::raii::CommandBuffer& commands) {
      const auto transit = [&](Access from, Layout before, Access to, Layout after) {
        const vk::ImageMemoryBarrier2 barrier(Stage::eAllCommands, from, Stage::eAllCommands, to, before, after,
                                              VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, image, whole);
        commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barrier));
      };
      transit(Access::eNone, Layout::eUndefined, Access::eTransferWrite, Layout::eTransferDstOptimal);
      commands.copyBufferToImage(*staging.buffer, image, Layout::eTransferDstOptimal,
                                 vk::BufferImageCopy(0, 0, 0, layers, {0, 0, 0},
                                                     {std::uint32_t(picture.width), std::uint32_t(picture.height), 1}));
      transit(Access::eTransferWrite, Layout::eTransferDstOptimal, Access::eTransferRead, Layout::eTransferSrcOptimal);
    });
  });
}

}  // namespace sinew
