#pragma once
/// The picture of a renderer as an image on the device, for windows. Vulkan types inside.

#include "engine/gpu/target.h"
#include "engine/render/renderer.h"

namespace sinew {

/// Its colour image holds the picture of the last draw_for_window() or put_picture(), in the layout
/// eTransferSrcOptimal. Another target after resize().
const Target& picture_target(const Renderer& renderer);
inline const DeviceImage& picture_image(const Renderer& renderer) { return picture_target(renderer).colour; }

/// Puts a picture of the renderer's size there in place of what it drew last. Fails as device_failed.
Result<void> put_picture(VulkanDevice& vulkan, const Renderer& renderer, const Picture& picture);

}  // namespace sinew
