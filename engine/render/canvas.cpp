#include "engine/render/canvas.h"

#include <cassert>
#include <cstdint>

#include "engine/render/stroke.h"

namespace sinew {
namespace {

constexpr int largest_mask_side = 4096;
constexpr double largest_dilation = 32.0;

/// A rounded quotient of numbers that are not negative.
std::uint8_t rounded_quotient(std::int64_t numerator, std::int64_t denominator) {
  return static_cast<std::uint8_t>((numerator + denominator / 2) / denominator);
}

bool positive(double a) { return std::isfinite(a) && a > 0.0; }

void make_sense_of_strokes(Contour& triangle) {
  const Vec2 a = triangle[1] - triangle[0], b = triangle[2] - triangle[0];
  if (a.x * b.y - a.y * b.x < 0.0) std::swap(triangle[1], triangle[2]);
}

}  // namespace

Mask mask_of(std::span<const Contour> contours) {
  Vec2 low(INFINITY), high(-INFINITY);
  for (const Contour& contour : contours) {
    for (const Vec2& p : contour) {
      if (!(std::abs(p.x) < 1e8 && std::abs(p.y) < 1e8)) return {};
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  if (low.x > high.x) return {};
  Mask mask;
  mask.x = int(std::floor(low.x));
  mask.y = int(std::floor(low.y));
  mask.width = std::min(int(std::ceil(high.x)) - mask.x + 1, largest_mask_side);
  mask.height = std::min(int(std::ceil(high.y)) - mask.y + 1, largest_mask_side);
  mask.coverage.resize(std::size_t(mask.width) * mask.height);
  std::vector<Contour> moved(contours.begin(), contours.end());
  for (Contour& contour : moved)
    for (Vec2& p : contour) p -= Vec2(mask.x, mask.y);
  rasterise(moved, mask.width, mask.height, [&](const CoverageRow& row) {
    std::copy(row.coverage.begin(), row.coverage.end(),
              mask.coverage.begin() + std::ptrdiff_t(row.y) * mask.width + row.x);
  });
  return mask;
}

Mask dilated(const Mask& mask, double radius) {
  if (!positive(radius)) return mask;
  const double clamped = std::min(radius, largest_dilation);
  const int reach = int(std::ceil(clamped));
  Mask grown{mask.x - reach, mask.y - reach, mask.width + 2 * reach, mask.height + 2 * reach, {}};
  grown.coverage.resize(std::size_t(grown.width) * grown.height);
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      // The brush is a disc whose own border is soft, in steps that keep the product within an int.
      const int weight = int(256.0 * std::clamp(clamped + 0.5 - std::sqrt(double(dx * dx + dy * dy)), 0.0, 1.0));
      if (weight == 0) continue;
      for (int y = 0; y < mask.height; ++y) {
        const int* from = &mask.coverage[std::size_t(y) * mask.width];
        int* to = &grown.coverage[std::size_t(y + dy + reach) * grown.width + (dx + reach)];
        for (int x = 0; x < mask.width; ++x) to[x] = std::max(to[x], from[x] * weight / 256);
      }
    }
  }
  return grown;
}

Colour faded(const Colour& colour, double by) {
  Colour result = colour;
  result.alpha = static_cast<std::uint8_t>(std::lround(colour.alpha * std::clamp(by, 0.0, 1.0)));
  return result;
}

Canvas::Canvas(Picture& picture) : picture_(&picture) {
  assert(picture.rgba.size() == std::size_t{4} * picture.width * picture.height);
}

void Canvas::blend(int x, int y, const Colour& colour, int coverage) {
  // Porter and Duff's "over" with straight alpha, all in integers: shares of alpha in units of 1 / (255 full_coverage).
  const std::int64_t over = std::int64_t{colour.alpha} * coverage;
  if (over == 0) return;
  std::uint8_t* pixel = &picture_->rgba[(std::size_t(y) * picture_->width + x) * 4];
  constexpr std::int64_t whole = std::int64_t{255} * full_coverage;
  const std::int64_t from_colour = over * 255, from_pixel = pixel[3] * (whole - over), sum = from_colour + from_pixel;
  const std::uint8_t channels[3] = {colour.red, colour.green, colour.blue};
  for (int c = 0; c < 3; ++c) pixel[c] = rounded_quotient(channels[c] * from_colour + pixel[c] * from_pixel, sum);
  pixel[3] = rounded_quotient(sum, whole);
}

void Canvas::fill(std::span<const Contour> contours, const Colour& colour) {
  rasterise(contours, width(), height(), [&](const CoverageRow& row) {
    for (std::size_t i = 0; i < row.coverage.size(); ++i) blend(row.x + int(i), row.y, colour, row.coverage[i]);
  });
}

void Canvas::polygon(const Contour& corners, const Colour& colour) { fill(std::span(&corners, 1), colour); }

void Canvas::line(const Vec2& from, const Vec2& to, const Stroke& stroke) {
  const Vec2 points[] = {from, to};
  polyline(points, stroke);
}

void Canvas::polyline(std::span<const Vec2> points, const Stroke& stroke, bool closed) {
  fill(stroke_contours(points, stroke, closed, width(), height()), stroke.colour);
}

void Canvas::arrow(const Vec2& from, const Vec2& to, const Stroke& stroke, double head) {
  const double length = glm::distance(from, to);
  if (!positive(length) || !positive(head)) return;
  const Vec2 direction = (to - from) / length, side(-direction.y, direction.x);
  const double reach = std::min(head, length);
  const Vec2 neck = to - reach * direction, shaft[] = {from, neck};
  std::vector<Contour> contours = stroke_contours(shaft, stroke, false, width(), height());
  Contour triangle{to, neck + 0.42 * reach * side, neck - 0.42 * reach * side};
  make_sense_of_strokes(triangle);
  contours.push_back(std::move(triangle));
  fill(contours, stroke.colour);
}

void Canvas::disc(const Vec2& centre, double radius, const Colour& colour) {
  filled_ellipse(centre, Vec2(radius), 0.0, colour);
}

void Canvas::circle(const Vec2& centre, double radius, const Stroke& stroke) {
  ellipse(centre, Vec2(radius), 0.0, stroke);
}

void Canvas::ellipse(const Vec2& centre, const Vec2& radii, double turn, const Stroke& stroke) {
  if (positive(radii.x) && positive(radii.y)) polyline(ellipse_contour(centre, radii, turn), stroke, true);
}

void Canvas::filled_ellipse(const Vec2& centre, const Vec2& radii, double turn, const Colour& colour) {
  if (positive(radii.x) && positive(radii.y)) polygon(ellipse_contour(centre, radii, turn), colour);
}

void Canvas::rounded_box(const Rect& box, double radius, const Colour& colour, const std::optional<Stroke>& border) {
  if (!positive(box.size().x) || !positive(box.size().y) || !std::isfinite(radius)) return;
  const Contour contour = rounded_contour(box, radius);
  polygon(contour, colour);
  if (border) polyline(contour, *border, true);
}

void Canvas::stamp(const Mask& mask, const Colour& colour) {
  const int left = std::max(mask.x, 0), right = std::min(mask.x + mask.width, width());
  for (int y = std::max(mask.y, 0); y < std::min(mask.y + mask.height, height()); ++y)
    for (int x = left; x < right; ++x)
      blend(x, y, colour, mask.coverage[std::size_t(y - mask.y) * mask.width + (x - mask.x)]);
}

std::optional<double> Canvas::brightness(const Rect& box) const {
  if (!(std::isfinite(box.low.x + box.low.y) && std::isfinite(box.high.x + box.high.y))) return {};
  const Vec2 corner(width(), height());
  const Rect inside{glm::clamp(box.low, Vec2(0.0), corner), glm::clamp(box.high, Vec2(0.0), corner)};
  std::int64_t sum = 0, pixels = 0;
  for (int y = int(std::floor(inside.low.y)); y < inside.high.y; ++y) {
    for (int x = int(std::floor(inside.low.x)); x < inside.high.x; ++x) {
      const std::uint8_t* p = &picture_->rgba[(std::size_t(y) * picture_->width + x) * 4];
      // Rec. 709 luma in parts of 10000, over the grey that pictures have by default.
      const int luma = 2126 * p[0] + 7152 * p[1] + 722 * p[2];
      sum += luma * p[3] + 216 * 10000 * (255 - p[3]);
      ++pixels;
    }
  }
  if (pixels == 0) return {};
  return double(sum) / (double(pixels) * 255.0 * 255.0 * 10000.0);
}

}  // namespace sinew
