#pragma once
/// The measured parts that a body is the union of, each a signed distance (engine/definitions.md 11). Lengths are
/// fractions of body height.

#include <string>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

/// A value of a field in space, negative inside, and its gradient.
struct FieldSample {
  double distance = 0.0;
  Vec3 gradient{0.0};
};

/// Radii over a grid: rows along the part, columns round it, between them Catmull-Rom splines.
struct RadiusTable {
  int rows = 0, columns = 0;
  std::vector<double> values;  ///< [rows * columns]

  struct Sample {
    double radius = 0.0, by_row = 0.0, by_column = 0.0;  ///< the slopes are per row and per column
  };
  /// `row` is clamped to 0..rows-1, `column` is periodic.
  Sample at(double row, double column) const;
};

/// A part of the body. A tube has star-shaped sections along a polyline, at arc length t; a ball is star-shaped about a
/// centre.
struct BodyPart {
  std::string name;
  RadiusTable radius;

  // A tube's:
  std::vector<Vec3> axis;                  ///< [points] two or more
  std::vector<Vec3> u;                     ///< [points - 1] the direction of angle 0, at right angles to the segment
  double first = 0.0, last = 0.0;          ///< t of the first and the last section
  std::vector<Vec2> centre;                ///< [rows] of each section, along u and v = axis x u
  double cap_first = 0.0, cap_last = 0.0;  ///< how far the ends are rounded beyond the sections

  // A ball's; where `ball` is false these mean nothing.
  bool ball = false;
  Vec3 ball_centre{0.0}, pole{0.0}, zero{0.0};  ///< zero: longitude 0
  double warp = 0.0;

  /// Signed distance, true to first order near the surface. Asked of a point close to the part.
  FieldSample at(const Vec3& p) const;

  /// Tube: the surface at arc length t in direction `angle` (radians), the radius multiplied by `scale`.
  Vec3 on_surface(double t, double angle, double scale = 1.0) const;
  /// Tube: arc length at the point of the axis nearest to p; runs on past both ends.
  double along(const Vec3& p) const;
  /// Tube: direction of the axis at t; length of the whole; t at the axis' point `index`; the axis' place at t.
  Vec3 direction(double t) const;
  double length() const;
  double t_at(std::size_t index) const;
  Vec3 on_axis(double t) const;
  /// Tube: v of a segment.
  Vec3 v(std::size_t segment) const;

  /// Ball: the surface in direction of latitude and longitude (radians).
  Vec3 on_ball(double latitude, double longitude) const;

 private:
  struct Foot {
    std::size_t segment = 0;
    double t = 0.0;
    bool in_corner = false;  ///< nearest to a corner of the polyline: t does not change with p
  };
  Foot foot_of(const Vec3& p) const;
  std::size_t segment_at(double t) const;
  double row_of(double t) const;
  double rows_per_length() const;
  /// The section's centre at t and its slope.
  void section_centre(double t, Vec2& centre_at, Vec2& slope) const;
  FieldSample tube_at(const Vec3& p) const;
  FieldSample ball_at(const Vec3& p) const;
};

}  // namespace sinew
