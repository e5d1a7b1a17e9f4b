#pragma once
/// What an X server without a screen shows: Xvfb keeps it in a file of the X Window Dump format, X11/XWDFile.h.

#include <cstdint>
#include <string>

#include "engine/core/files.h"

namespace sinew::test {

/// Pixels of the screen that are exactly this colour, 0xRRGGBB; -1 where the file is no dump of 32 bits a pixel.
inline int screen_pixels(const std::string& file, std::uint32_t colour) {
  const auto bytes = read_file(file);
  if (!bytes) return -1;
  constexpr std::size_t header_words = 25, bytes_per_colour = 12;
  if (bytes->size() < 4 * header_words) return -1;
  // The header is big-endian whatever the pixels are.
  const auto header = [&](std::size_t word) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | (*bytes)[4 * word + i];
    return value;
  };
  const std::size_t width = header(4), height = header(5), line = header(12);
  const std::size_t begin = header(0) + bytes_per_colour * header(19);
  const bool low_byte_first = header(7) == 0;
  if (header(11) != 32 || !low_byte_first || bytes->size() < begin + line * height) return -1;
  int count = 0;
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const unsigned char* pixel = bytes->data() + begin + line * y + 4 * x;
      const std::uint32_t blue = pixel[0], green = pixel[1], red = pixel[2];
      count += (red << 16 | green << 8 | blue) == colour;
    }
  return count;
}

}  // namespace sinew::test
