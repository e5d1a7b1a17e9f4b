#pragma once
/// The picture of a renderer as an image on the device, for windows. Vulkan types inside.

#include "engine/gpu/vulkan.h"
#include "engine/render/renderer.h"

namespace sinew {

/// Holds the picture of the last draw_for_window(), in the layout eTransferSrcOptimal. Another image after resize().
const DeviceImage& picture_image(const Renderer& renderer);

}  // namespace sinew
