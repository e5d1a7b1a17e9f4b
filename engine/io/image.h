#pragma once
/// Pictures out of PNG and JPEG files, as textures need them.

#include <span>

#include "engine/core/result.h"
#include "engine/model/picture.h"

namespace sinew {

/// Decodes a PNG or JPEG; grey, palette, 16-bit and alpha-less pictures become 8-bit RGBA. Fails as bad_input where the
/// bytes are neither, are damaged, or hold a picture of over 16384 pixels a side or 128 million altogether.
Result<Picture> decode_image(std::span<const unsigned char> encoded);

}  // namespace sinew
