#pragma once
/// Lines as shapes: the outlines of strokes of a given width, of dashes and of round shapes.

#include <span>
#include <vector>

#include "engine/render/canvas.h"

namespace sinew {

/// The contours of a stroke, all of one sense of rotation: right-angled and blunter corners are mitred, sharper ones
/// round. Only what may be seen in a picture of width x height is made, however long the line is. A single point, or a
/// coordinate that is not finite, gives nothing.
std::vector<Contour> stroke_contours(std::span<const Vec2> points, const Stroke& stroke, bool closed, int width,
                                     int height);

/// An ellipse as a polygon that leaves it by less than 1/100 pixel; the sense of rotation is that of the strokes.
Contour ellipse_contour(const Vec2& centre, const Vec2& radii, double turn_degrees);

/// Corners cut to quarter circles; the radius is limited to half of the shorter side.
Contour rounded_contour(const Rect& box, double radius);

}  // namespace sinew
