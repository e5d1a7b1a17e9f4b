#pragma once
/// Pictures out of PNG and JPEG files, as textures need them.

#include <span>
#include <vector>

#include "engine/core/result.h"

namespace sinew {

/// Rows from top to bottom, four bytes a pixel, not premultiplied; colours as the file stores them (sRGB).
struct Image {
  int width = 0, height = 0;
  std::vector<unsigned char> rgba;  ///< [width * height * 4]
};

/// Decodes a PNG or JPEG; grey, palette, 16-bit and alpha-less pictures become 8-bit RGBA. Fails as bad_input where the
/// bytes are neither, are damaged, or hold a picture of over 16384 pixels a side or 128 million altogether.
Result<Image> decode_image(std::span<const unsigned char> encoded);

}  // namespace sinew
