#include "engine/io/image.h"

#include <cstdint>
#include <limits>
#include <memory>

// Compiled into this file alone, and only what the formats of glTF need.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#include <stb/stb_image.h>

namespace sinew {
namespace {

constexpr int longest_side = 16384;
constexpr std::int64_t most_pixels = std::int64_t{1} << 27;

}  // namespace

Result<Picture> decode_image(std::span<const unsigned char> encoded) {
  if (encoded.empty()) return bad_input("an empty picture; expected PNG or JPEG");
  if (encoded.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    return bad_input("a picture of {} bytes is too large", encoded.size());
  const int size = static_cast<int>(encoded.size());
  Picture image;
  int channels = 0;
  if (stbi_info_from_memory(encoded.data(), size, &image.width, &image.height, &channels) == 0)
    return bad_input("not a PNG or JPEG picture that can be read ({})", stbi_failure_reason());
  if (image.width <= 0 || image.height <= 0 || image.width > longest_side || image.height > longest_side ||
      std::int64_t{image.width} * image.height > most_pixels)
    return bad_input("a picture of {} x {} pixels; at most {} a side and {} altogether can be read", image.width,
                     image.height, longest_side, most_pixels);
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(encoded.data(), size, &image.width, &image.height, &channels, STBI_rgb_alpha),
      stbi_image_free);
  if (!pixels) return bad_input("a damaged picture ({})", stbi_failure_reason());
  image.rgba.assign(pixels.get(), pixels.get() + std::size_t{4} * static_cast<std::size_t>(image.width) *
                                                     static_cast<std::size_t>(image.height));
  return image;
}

}  // namespace sinew
