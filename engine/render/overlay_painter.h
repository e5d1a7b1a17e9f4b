#pragma once
/// What the parts of an overlay share: the canvas, the projection, the scale and the labels. Shapes are drawn at once,
/// labels at the end, so that they lie on top and keep clear of all of them.

#include <string>
#include <vector>

#include "engine/render/label_layout.h"
#include "engine/render/overlay.h"
#include "engine/render/screen.h"

namespace sinew {

/// Colours that read on light grey, on white and on dark backgrounds.
namespace palette {
constexpr Colour ink{26, 34, 43}, paper{255, 255, 255};
constexpr Colour bone{250, 244, 226}, joint{240, 138, 36}, root{0, 150, 136};
constexpr Colour muscle{200, 30, 60}, plane{70, 110, 220};
constexpr Colour box{100, 112, 126};
constexpr Colour axes[3] = {{214, 58, 54}, {56, 150, 60}, {52, 104, 220}};
}  // namespace palette

/// A text that is to be placed.
struct Label {
  std::string text;
  LabelRequest request;     ///< its size is filled in
  double importance = 0.0;  ///< the higher is placed first
  Colour tick;              ///< of the dot where its leader begins, and of a box's border
  bool boxed = false;
};

class OverlayPainter {
 public:
  OverlayPainter(Picture& picture, const Font* font, const Viewpoint& viewpoint);

  Canvas canvas;
  Screen screen;
  const Viewpoint& viewpoint;
  LabelLayout layout;

  /// A length that is `at_720` pixels in a picture 720 pixels high; small pictures keep lines and letters legible.
  double line(double at_720) const { return at_720 * line_scale_; }
  double letters(double at_720) const { return at_720 * letter_scale_; }

  void skeleton(const SkeletonOverlay& skeleton);
  void muscle(const MuscleOverlay& muscle);
  void muscle_plane(const MuscleOverlay& muscle);
  void muscle_points(const MuscleOverlay& muscle, double pixels_across);
  void muscle_feet(const MuscleOverlay& muscle, double dot);
  void muscle_gaussian(const MuscleOverlay& muscle, double bold);
  void face(const FaceOverlay& face);
  void face_guide(const FaceGuideLine& guide);
  void face_region(const FaceRegionOverlay& region);
  void face_region_labels(std::span<const FaceRegionOverlay> regions);
  void face_cuts(std::span<const SurfaceCut> cuts, const Colour& colour, double width);
  void box(const Bounds& box);
  void axes();

  void add_label(Label label);
  void draw_labels();

  /// A line in space, cut off at the near plane.
  void line_3d(const Vec3& a, const Vec3& b, const Stroke& stroke);
  void polyline_3d(std::span<const Vec3> points, const Stroke& stroke, bool closed);

  /// Light letters, not dark ones, are what can be read on this part of the picture.
  bool dark_under(const Rect& box) const { return canvas.brightness(box).value_or(1.0) < 0.42; }

 private:
  void draw_label(const Label& label, const PlacedLabel& place);

  const Font* font_;
  double line_scale_, letter_scale_;
  std::vector<Label> labels_;
};

}  // namespace sinew
