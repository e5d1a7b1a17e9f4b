#pragma once
/// Drawing on a finished picture: anti-aliased lines and shapes, and masks such as text, over sRGB bytes with straight
/// alpha; a transparent background is as good as any. Pixels are counted from the upper left corner, x to the right, y
/// down, centres at halves. Whatever lies outside the picture is left out, and a shape with a coordinate that is not
/// finite is not drawn. The same calls give the same bytes on every machine (engine/render/coverage.h).

#include <optional>
#include <span>
#include <vector>

#include "engine/model/picture.h"
#include "engine/model/scene.h"
#include "engine/render/coverage.h"

namespace sinew {

/// An upright box in pixels, from its upper left to its lower right corner.
struct Rect {
  Vec2 low{0.0}, high{0.0};

  Vec2 size() const { return high - low; }
  Vec2 centre() const { return 0.5 * (low + high); }
  Rect grown(double by) const { return {low - by, high + by}; }
  bool overlaps(const Rect& other) const {
    return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
  }
  bool contains(const Rect& other) const {
    return low.x <= other.low.x && low.y <= other.low.y && high.x >= other.high.x && high.y >= other.high.y;
  }
};

enum class Cap { butt, round };

/// How a line is drawn. Dashes of `dash` pixels alternate with gaps of `gap` pixels; 0: an unbroken line.
struct Stroke {
  Colour colour{};
  double width = 1.5;
  Cap cap = Cap::butt;
  double dash = 0.0, gap = 0.0;
};

/// Coverage of a box of pixels, which may lie partly outside a picture.
struct Mask {
  int x = 0, y = 0, width = 0, height = 0;
  std::vector<int> coverage;  ///< [height * width] 0 to full_coverage
};

/// The coverage of a shape, whatever pictures there are: at most 4096 pixels a side are kept.
Mask mask_of(std::span<const Contour> contours);

/// The mask grown by `radius` pixels, at most 32, in every direction: what a halo covers.
Mask dilated(const Mask& mask, double radius);

/// The colour with its alpha multiplied by 0 to 1.
Colour faded(const Colour& colour, double by);

class Canvas {
 public:
  /// The picture must outlive the canvas and hold as many bytes as its size says.
  explicit Canvas(Picture& picture);

  int width() const { return picture_->width; }
  int height() const { return picture_->height; }
  const Picture& picture() const { return *picture_; }

  /// Fills the union of contours of one sense of rotation; those of the other sense are holes.
  void fill(std::span<const Contour> contours, const Colour& colour);
  void polygon(const Contour& corners, const Colour& colour);

  void line(const Vec2& from, const Vec2& to, const Stroke& stroke);
  /// One stroke through all points: where it crosses itself it is not drawn twice.
  void polyline(std::span<const Vec2> points, const Stroke& stroke, bool closed = false);
  /// A line with a filled head of `head` pixels' length, whose point is at `to`.
  void arrow(const Vec2& from, const Vec2& to, const Stroke& stroke, double head);

  void disc(const Vec2& centre, double radius, const Colour& colour);
  void circle(const Vec2& centre, double radius, const Stroke& stroke);
  /// Half axes `radii`, the first one turned by `turn` degrees from x towards y.
  void ellipse(const Vec2& centre, const Vec2& radii, double turn, const Stroke& stroke);
  void filled_ellipse(const Vec2& centre, const Vec2& radii, double turn, const Colour& colour);

  /// A box with rounded corners, filled and then outlined on its border.
  void rounded_box(const Rect& box, double radius, const Colour& colour, const std::optional<Stroke>& border = {});

  void stamp(const Mask& mask, const Colour& colour);

  /// The mean luma, 0 to 1, of what lies under a box; transparency counts as light grey. Nothing where the box lies
  /// outside.
  std::optional<double> brightness(const Rect& box) const;

 private:
  void blend(int x, int y, const Colour& colour, int coverage);

  Picture* picture_;
};

}  // namespace sinew
