#pragma once
/// How much of each pixel a shape covers: exact areas, no samples. Corners are rounded to 1/256 pixel and from there on
/// everything is integers, so that the same shape gives the same bytes on every machine.

#include <functional>
#include <span>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

/// The corners of a closed polygon in pixels: x to the right, y down, (0, 0) the picture's upper left corner, so that
/// pixel centres lie at halves.
using Contour = std::vector<Vec2>;

/// The coverage of a pixel that is wholly inside.
constexpr int full_coverage = 2 * 256 * 256;

/// Neighbouring pixels of one row; those beyond either end are not covered.
struct CoverageRow {
  int x = 0, y = 0;               ///< of the first pixel
  std::span<const int> coverage;  ///< 0 to full_coverage
};

/// Calls `emit` once for each row that the contours touch, top to bottom, clipped to a picture of width x height.
/// Contours of one sense of rotation unite where they overlap; one of the other sense cuts a hole. The area of a union
/// is exact but for pixels in which the borders of two contours overlap. A shape with a corner that is not finite is
/// empty.
void rasterise(std::span<const Contour> contours, int width, int height,
               const std::function<void(const CoverageRow&)>& emit);

}  // namespace sinew
