#pragma once
/// Viewpoints: where the camera stands, and framing a box exactly. No Vulkan here.

#include "engine/core/math.h"

namespace sinew {

constexpr double vertical_field_of_view_degrees = 30.0;

/// Where a picture is taken from.
struct Viewpoint {
  Vec3 eye{0, 0, 5};
  Vec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};  ///< the camera's axes in the world; it looks along -back
  double near_plane = 0.1, far_plane = 100.0;
  /// World length that the picture is high where all rays run along -back; 0: they come from the eye.
  double parallel_height = 0.0;

  bool is_parallel() const { return parallel_height > 0.0; }
  /// The direction in which a point is seen, from it to the eye; any length.
  Vec3 towards_eye(const Vec3& p) const { return is_parallel() ? back : eye - p; }
  /// World length that the picture is high at a point's distance.
  double height_at(const Vec3& p) const;
  /// World to Vulkan clip space (y down, depth 0 at the near plane to 1 at the far one).
  Mat4 view_projection(double aspect) const;
};

/// A direction to look from: degrees the camera is turned counter-clockwise about +Y seen from above (0: it stands on
/// +Z, 90: on +X, the character's own left), and degrees it is raised.
struct ViewDirection {
  double azimuth = 0.0;
  double elevation = 0.0;
};

/// How rays reach the picture.
enum class Rays {
  from_eye,  ///< perspective
  parallel,  ///< orthographic, as high as perspective is at the target's distance
};

/// World length that a picture is high at a distance from the eye.
double seen_height(double distance);

/// Looks at the box's centre from the smallest distance at which all its corners are seen with a margin of 4 % of the
/// picture on each side. `aspect` is width / height.
Viewpoint frame_box(const Bounds& box, const ViewDirection& direction, double aspect, Rays rays = Rays::from_eye);

/// The camera at `distance` from `target`, its near and far planes round the box.
Viewpoint look_at(const Vec3& target, double distance, const Bounds& box, const ViewDirection& direction,
                  Rays rays = Rays::from_eye);

}  // namespace sinew
