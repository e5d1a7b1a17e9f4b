#include "engine/render/picture_compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace sinew {
namespace {

/// Makes a difference of one level visible to the eye.
constexpr int amplification = 8;

Result<void> check_sizes(const Picture& a, const Picture& b) {
  if (a.width == b.width && a.height == b.height) return {};
  return bad_input("the pictures' sizes differ: {}x{} and {}x{}", a.width, a.height, b.width, b.height);
}

/// One number a pixel, rows from the top.
struct Plane {
  int width = 0, height = 0;
  std::vector<double> values;
};

/// Rec. 709 luma, 0 to 1, over mid-grey.
Plane luma(const Picture& picture) {
  Plane plane{picture.width, picture.height, {}};
  for (std::size_t pixel = 0; pixel < picture.rgba.size(); pixel += 4) {
    const std::uint8_t* c = &picture.rgba[pixel];
    const double alpha = c[3] / 255.0;
    plane.values.push_back(alpha * (0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]) / 255.0 + (1.0 - alpha) * 0.5);
  }
  return plane;
}

Plane product(const Plane& a, const Plane& b) {
  Plane result = a;
  for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] *= b.values[i];
  return result;
}

/// Gaussian of sigma 1.5, 11 pixels wide, along one direction; the border repeats.
Plane blurred_along(const Plane& plane, int dx, int dy) {
  constexpr int reach = 5;
  double kernel[2 * reach + 1], sum = 0.0;
  for (int i = -reach; i <= reach; ++i) sum += kernel[i + reach] = std::exp(-i * i / (2.0 * 1.5 * 1.5));
  Plane result = plane;
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x) {
      double value = 0.0;
      for (int i = -reach; i <= reach; ++i) {
        const int px = std::clamp(x + i * dx, 0, plane.width - 1), py = std::clamp(y + i * dy, 0, plane.height - 1);
        value += kernel[i + reach] * plane.values[static_cast<std::size_t>(py) * plane.width + px];
      }
      result.values[static_cast<std::size_t>(y) * plane.width + x] = value / sum;
    }
  return result;
}

Plane blurred(const Plane& plane) { return blurred_along(blurred_along(plane, 1, 0), 0, 1); }

}  // namespace

Result<PixelComparison> compare_pixels(const Picture& a, const Picture& b, int tolerance) {
  if (auto ok = check_sizes(a, b); !ok) return pass_on(std::move(ok));
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

Result<double> structural_dissimilarity(const Picture& a, const Picture& b) {
  if (auto ok = check_sizes(a, b); !ok) return pass_on(std::move(ok));
  if (a.rgba.empty()) return 0.0;
  const Plane x = luma(a), y = luma(b);
  const Plane mean_x = blurred(x), mean_y = blurred(y);
  const Plane xx = blurred(product(x, x)), yy = blurred(product(y, y)), xy = blurred(product(x, y));
  constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
  double sum = 0.0;
  for (std::size_t i = 0; i < x.values.size(); ++i) {
    const double mx = mean_x.values[i], my = mean_y.values[i];
    const double variances = xx.values[i] - mx * mx + yy.values[i] - my * my;
    const double covariance = xy.values[i] - mx * my;
    sum += (2 * mx * my + c1) * (2 * covariance + c2) / ((mx * mx + my * my + c1) * (variances + c2));
  }
  return 1.0 - sum / static_cast<double>(x.values.size());
}

Picture difference_picture(const Picture& a, const Picture& b) {
  Picture result{a.width, a.height, std::vector<std::uint8_t>(a.rgba.size(), 255)};
  for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4)
    for (std::size_t c = 0; c < 3; ++c)
      result.rgba[pixel + c] =
          static_cast<std::uint8_t>(std::min(255, amplification * std::abs(a.rgba[pixel + c] - b.rgba[pixel + c])));
  return result;
}

}  // namespace sinew
