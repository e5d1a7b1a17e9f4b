#pragma once
/// The picture of a renderer as an image on the device, for windows. Vulkan types inside.

#include "engine/gpu/vulkan.h"
#include "engine/render/renderer.h"

namespace sinew {

/// Holds the picture of the last draw_for_window() or put_picture(), in the layout eTransferSrcOptimal. Another image
/// after resize().
const DeviceImage& picture_image(const Renderer& renderer);

/// Puts a picture of the renderer's size there in place of what it drew last. Fails as device_failed.
Result<void> put_picture(VulkanDevice& vulkan, const Renderer& renderer, const Picture& picture);

}  // namespace sinew
