#pragma once
#include <cstddef>

#include "engine/core/result.h"
#include "engine/model/picture.h"

namespace sinew {

struct PixelComparison {
  std::size_t pixels = 0;
  std::size_t pixels_over = 0;  ///< with a channel (alpha too) that differs by more than the tolerance
  int largest_difference = 0;   ///< levels of 255
};

/// Compares two pictures pixel by pixel. Fails as bad_input where their sizes differ.
Result<PixelComparison> compare_pixels(const Picture& a, const Picture& b, int tolerance);

/// The difference made visible: every channel's difference times eight, opaque. Same sizes.
Picture difference_picture(const Picture& a, const Picture& b);

}  // namespace sinew
