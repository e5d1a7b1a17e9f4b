#pragma once
/// Numbers on a plot's axes and pixels, there and back. No Vulkan and no window here.

#include <algorithm>
#include <cmath>

#include "engine/core/math.h"

namespace sinew {

/// A range of numbers; empty until something is added.
struct PlotRange {
  double low = INFINITY, high = -INFINITY;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double length() const { return high - low; }
  /// A share more at either side, and never less than `least` long; 0 to 1 where it is empty.
  PlotRange widened(double share, double least) const {
    if (!(low <= high)) return {0.0, 1.0};
    const double more = std::max(share * length(), 0.5 * (least - length()));
    return {low - more, high + more};
  }
};

struct PlotScale {
  PlotRange x, y;               ///< shown, of length above 0
  Vec2 corner{0.0}, size{1.0};  ///< upper left corner and size of the plot, pixels

  Vec2 to_pixel(double at, double value) const {
    return {corner.x + size.x * (at - x.low) / x.length(), corner.y + size.y * (y.high - value) / y.length()};
  }
  double x_of(double pixel) const { return x.low + x.length() * (pixel - corner.x) / size.x; }
  double y_of(double pixel) const { return y.high - y.length() * (pixel - corner.y) / size.y; }
  /// Of a slope, y a unit of x, in pixels: down for rising ones.
  double pixel_slope(double slope) const { return -slope * (size.y / y.length()) / (size.x / x.length()); }
  double slope_of(double pixel_slope) const { return -pixel_slope * (size.x / x.length()) / (size.y / y.length()); }
};

}  // namespace sinew
