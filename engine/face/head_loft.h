#pragma once
/// The bare skull as a surface: measured sections, joined smoothly.

#include <array>

#include "engine/face/head_measures.h"

namespace sinew {

/// r(theta, y) round the axis x = z = 0: Catmull-Rom splines round each section, cubic Hermite between the heights,
/// r^2 linear towards the crown; widened by factors that lie on a monotone cubic in y. Units of the measures; theta in
/// degrees, 0 front, 90 the side that is modelled, 180 back.
class HeadLoft {
 public:
  explicit HeadLoft(const HeadMeasures& measures);

  Vec3 at(double theta, double y) const;
  /// Depth of the front or side at a distance x from the middle; that of the side's edge where x lies outside.
  double depth(double x, double y) const;
  /// Depth of the mid line's front.
  double front(double y) const { return depth(0.0, y); }
  /// The theta at which the surface has this depth, from 20 to 170.
  double theta_of_depth(double z, double y) const;
  /// The height, at least `lowest`, at which the surface is this far from the axis: the crown's inverse.
  double height_of(double theta, double distance, double lowest) const;
  /// The widening at a height.
  double width_factor(double y) const;

 private:
  double radius(double theta, double y) const;
  double row_radius(std::size_t row, double theta) const;

  SkullSections sections_;
  std::array<double, 7> width_heights_, widths_, slopes_;
};

}  // namespace sinew
