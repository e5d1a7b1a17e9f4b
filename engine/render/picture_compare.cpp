#include "engine/render/picture_compare.h"

#include <algorithm>
#include <cstdlib>

namespace sinew {
namespace {

/// Makes a difference of one level visible to the eye.
constexpr int amplification = 8;

}  // namespace

Result<PixelComparison> compare_pixels(const Picture& a, const Picture& b, int tolerance) {
  if (a.width != b.width || a.height != b.height)
    return bad_input("the pictures' sizes differ: {}x{} and {}x{}", a.width, a.height, b.width, b.height);
  PixelComparison result;
  result.pixels = a.rgba.size() / 4;
  for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
    int largest = 0;
    for (std::size_t c = 0; c < 4; ++c) largest = std::max(largest, std::abs(a.rgba[pixel + c] - b.rgba[pixel + c]));
    if (largest > tolerance) ++result.pixels_over;
    result.largest_difference = std::max(result.largest_difference, largest);
  }
  return result;
}

Picture difference_picture(const Picture& a, const Picture& b) {
  Picture result{a.width, a.height, std::vector<std::uint8_t>(a.rgba.size(), 255)};
  for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4)
    for (std::size_t c = 0; c < 3; ++c)
      result.rgba[pixel + c] = static_cast<std::uint8_t>(
          std::min(255, amplification * std::abs(a.rgba[pixel + c] - b.rgba[pixel + c])));
  return result;
}

}  // namespace sinew
