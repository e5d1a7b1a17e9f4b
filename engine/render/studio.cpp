#include "engine/render/studio.h"

#include "engine/render/frustum.h"

namespace sinew {
namespace {

// In the camera's axes: right, up, towards the camera.
constexpr Vec3 key_direction{-0.52, 0.62, 0.59};
constexpr Vec3 fill_direction{0.86, 0.05, 0.50};
constexpr Vec3 rim_direction{0.55, 0.45, -0.70};

/// Of the scene's diagonal.
constexpr double contact_reach_share = 0.10;
/// A foot may sink into the floor by this much of the reach.
constexpr double sunk_share = 0.2;

/// Rows of an affine map from the world to clip space.
Mat4 from_rows(const Vec4& x, const Vec4& y, const Vec4& z) { return glm::transpose(Mat4(x, y, z, Vec4(0, 0, 0, 1))); }

/// (dot(p, axis) - at) * scale as a row.
Vec4 row(const Vec3& axis, double at, double scale) { return Vec4(axis * scale, -at * scale); }

/// The axes of a light's map: right, up, and away from the light.
Mat3 light_axes(const Vec3& to_light) {
  const Vec3 helper = std::abs(to_light.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
  const Vec3 right = glm::normalize(glm::cross(helper, to_light));
  return {right, glm::cross(to_light, right), -to_light};
}

Bounds box_along(const Mat3& axes, std::span<const Vec3> points) {
  Bounds box;
  for (const Vec3& p : points) box.add(glm::transpose(axes) * p);
  return box;
}

/// Half the side of the least square map, and its centre, that hold what is seen and can be in shadow.
void aim_light(const Frustum& seen, const Bounds& scene, std::span<const Vec3> floor, Studio& studio) {
  const Mat3 axes = light_axes(studio.key);
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(scene.corner(i));
  const Bounds whole = box_along(axes, corners);
  std::vector<Vec3> points = seen_part(seen, scene);
  const std::vector<Vec3> seen_floor = clipped_polygon({floor.begin(), floor.end()}, seen.planes);
  points.insert(points.end(), seen_floor.begin(), seen_floor.end());
  Bounds window = points.empty() ? whole : box_along(axes, points);
  window.low = glm::max(window.low, whole.low);
  window.high = glm::min(window.high, whole.high);
  if (window.low.x > window.high.x || window.low.y > window.high.y) window = whole;
  // The filter looks a little over the edge.
  const double half =
      0.51 * std::max({window.high.x - window.low.x, window.high.y - window.low.y, 1e-3 * scene.diagonal()});
  const Vec3 at = window.centre();
  studio.light_projection = from_rows(row(axes[0], at.x, 1.0 / half), row(axes[1], at.y, -1.0 / half),
                                      row(axes[2], whole.low.z, 1.0 / (whole.high.z - whole.low.z)));
  studio.shadow_width = 2.0 * half;
}

/// Where a point's shadow falls on the floor, no farther than `farthest`.
Vec3 shadow_of(const Vec3& p, const Vec3& to_light, double floor_height, double farthest) {
  const Vec2 along = -Vec2(to_light.x, to_light.z);
  const double slope = glm::length(along) / std::max(to_light.y, 1e-6);
  const double distance = std::min(std::max(p.y - floor_height, 0.0) * slope, farthest);
  const Vec2 moved = glm::length(along) > 0.0 ? distance * glm::normalize(along) : Vec2(0.0);
  return {p.x + moved.x, floor_height, p.z + moved.y};
}

}  // namespace

Studio make_studio(const Viewpoint& viewpoint, double aspect, const Bounds& scene, double floor_height) {
  const auto in_world = [&](const Vec3& v) {
    return glm::normalize(v.x * viewpoint.right + v.y * viewpoint.up + v.z * viewpoint.back);
  };
  Studio studio;
  studio.key = in_world(key_direction);
  studio.fill = in_world(fill_direction);
  studio.rim = in_world(rim_direction);

  const Vec3 centre = scene.centre(), size = scene.high - scene.low;
  const double diagonal = std::max(scene.diagonal(), 1e-9);
  const double reach = contact_reach_share * diagonal;
  const double half = 0.5 * std::max(size.x, size.z) + 1.5 * reach;
  const double lowest = floor_height - sunk_share * reach;
  studio.contact_projection = from_rows(row({1, 0, 0}, centre.x, 1.0 / half), row({0, 0, 1}, centre.z, 1.0 / half),
                                        row({0, 1, 0}, lowest, 1.0 / ((1.0 + sunk_share) * reach)));
  studio.contact_reach = reach / (2.0 * half);
  studio.fading_distance = 1.5 * diagonal;

  Bounds reached;
  for (const double side : {-1.0, 1.0}) reached.add(Vec3(centre.x + side * half, floor_height, centre.z + side * half));
  for (int i = 0; i < 8; ++i) reached.add(shadow_of(scene.corner(i), studio.key, floor_height, studio.fading_distance));
  studio.floor_centre = {reached.centre().x, floor_height, reached.centre().z};
  studio.floor_half_size = 0.5 * Vec2(reached.high.x - reached.low.x, reached.high.z - reached.low.z);

  std::vector<Vec3> floor_corners;
  studio.viewpoint = viewpoint;
  for (const Vec2& side : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
    const Vec2 away = side * studio.floor_half_size;
    floor_corners.push_back(studio.floor_centre + Vec3(away.x, 0.0, away.y));
    const double depth = glm::dot(viewpoint.eye - floor_corners.back(), viewpoint.back);
    studio.viewpoint.far_plane = std::max(studio.viewpoint.far_plane, 1.01 * depth);
    if (viewpoint.is_parallel()) studio.viewpoint.near_plane = std::min(studio.viewpoint.near_plane, depth);
  }
  // A bulge or a strand of hair may leave the box a little.
  Bounds grown = scene;
  grown.low -= 0.05 * diagonal;
  grown.high += 0.05 * diagonal;
  aim_light(frustum_of(studio.viewpoint, aspect), grown, floor_corners, studio);
  return studio;
}

}  // namespace sinew
