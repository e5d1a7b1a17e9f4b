#include "engine/render/studio.h"

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

Mat4 light_projection(const Vec3& to_light, const Vec3& centre, double radius) {
  const Vec3 helper = std::abs(to_light.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
  const Vec3 right = glm::normalize(glm::cross(helper, to_light)), up = glm::cross(to_light, right);
  const Vec3 away = -to_light;
  return from_rows(row(right, glm::dot(right, centre), 1.0 / radius), row(up, glm::dot(up, centre), -1.0 / radius),
                   row(away, glm::dot(away, centre) - radius, 0.5 / radius));
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

Studio make_studio(const Viewpoint& viewpoint, const Bounds& scene, double floor_height) {
  const auto in_world = [&](const Vec3& v) {
    return glm::normalize(v.x * viewpoint.right + v.y * viewpoint.up + v.z * viewpoint.back);
  };
  Studio studio;
  studio.key = in_world(key_direction);
  studio.fill = in_world(fill_direction);
  studio.rim = in_world(rim_direction);

  const Vec3 centre = scene.centre(), size = scene.high - scene.low;
  const double diagonal = std::max(scene.diagonal(), 1e-9);
  // A bulge or a strand of hair may leave the box a little.
  const double radius = 0.55 * diagonal;
  studio.light_projection = light_projection(studio.key, centre, radius);
  studio.shadow_width = 2.0 * radius;

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
  return studio;
}

}  // namespace sinew
