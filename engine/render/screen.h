#pragma once
/// From the world to a picture's pixels: points, and lines and polygons cut off at the near plane.

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/render/coverage.h"
#include "engine/render/viewpoint.h"

namespace sinew {

struct ScreenPoint {
  Vec2 at{0.0};        ///< pixels from the upper left corner
  double depth = 0.0;  ///< distance from the eye along the line of sight, world units
};

class Screen {
 public:
  Screen(const Viewpoint& viewpoint, int width, int height);

  /// Nothing where the point lies before the near plane, or is not finite.
  std::optional<ScreenPoint> point(const Vec3& p) const;

  /// The part of a segment beyond the near plane.
  std::optional<std::pair<ScreenPoint, ScreenPoint>> segment(const Vec3& a, const Vec3& b) const;

  /// The part of a convex polygon beyond the near plane; empty where there is none.
  Contour polygon(std::span<const Vec3> corners) const;

  /// True where a surface with this normal shows its front.
  bool faces(const Vec3& p, const Vec3& normal) const { return glm::dot(normal, towards_eye(p)) > 0.0; }
  /// From a point to where it is seen from; any length.
  Vec3 towards_eye(const Vec3& p) const { return Vec3(eye_) - eye_.w * p; }

 private:
  Vec4 clip(const Vec3& p) const { return view_projection_ * Vec4(p, 1.0); }
  ScreenPoint on_screen(const Vec4& clip) const;

  Mat4 view_projection_;
  Vec4 eye_;          ///< its place and 1; of parallel rays their direction towards it and 0
  Vec2 parallel_{0};  ///< of parallel rays: the near plane's distance, and how much farther the far one is
  Vec2 size_;
};

}  // namespace sinew
