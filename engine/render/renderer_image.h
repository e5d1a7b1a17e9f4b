#pragma once
/// The picture of a renderer as an image on the device, for windows. Vulkan types inside.

#include "engine/gpu/target.h"
#include "engine/render/renderer.h"

namespace sinew {

/// Its colour image holds the picture of the last draw_for_window(), in the layout eTransferSrcOptimal. Another target
/// after resize().
const Target& picture_target(const Renderer& renderer);
inline const DeviceImage& picture_image(const Renderer& renderer) { return picture_target(renderer).colour; }

}  // namespace sinew
