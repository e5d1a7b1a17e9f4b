#pragma once
/// FLIP: how different two pictures look to somebody who flips between them.

#include <vector>

#include "engine/core/result.h"
#include "engine/model/picture.h"

namespace sinew {

/// The error of every pixel, rows from the top.
struct FlipMap {
  int width = 0, height = 0;
  std::vector<float> errors;  ///< [height * width] 0 equal to 1 as different as can be

  double mean() const;
};

/// Seen from 0.7 m on a screen 0.7 m wide with 3840 pixels: pixels a degree.
constexpr double flip_pixels_per_degree = 67.0206;

/// LDR-FLIP (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and Fairchild 2020), definitions.md section 9. What
/// is transparent is seen over mid-grey. Fails as bad_input where the sizes differ.
Result<FlipMap> flip(const Picture& a, const Picture& b, double pixels_per_degree = flip_pixels_per_degree);

}  // namespace sinew
