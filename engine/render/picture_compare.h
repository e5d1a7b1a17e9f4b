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

/// 1 - mean structural similarity of the luma (Wang et al. 2004: Gaussian window of sigma 1.5, K1 0.01, K2 0.03), 0 for
/// equal pictures. What is transparent is seen over mid-grey. Fails as bad_input where the sizes differ.
Result<double> structural_dissimilarity(const Picture& a, const Picture& b);

/// The difference made visible: every channel's difference times eight, opaque. Same sizes.
Picture difference_picture(const Picture& a, const Picture& b);

}  // namespace sinew
