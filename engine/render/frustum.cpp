#include "engine/render/frustum.h"

namespace sinew {
namespace {

/// Corner numbers of the six sides of a frustum, or of a box whose bits are x, y and z.
constexpr std::array<std::array<std::size_t, 4>, 6> sides{
    {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}}};

/// Of what three corners span, with `inside` on its positive side.
Vec4 plane_through(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& inside) {
  Vec3 normal = glm::normalize(glm::cross(b - a, c - a));
  if (glm::dot(normal, inside - a) < 0.0) normal = -normal;
  return {normal, -glm::dot(normal, a)};
}

double height(const Vec4& plane, const Vec3& p) { return glm::dot(Vec3(plane), p) + plane.w; }

template <class Corner>
std::vector<Vec3> side_of(const Corner& corner, const std::array<std::size_t, 4>& side) {
  std::vector<Vec3> polygon;
  for (const std::size_t i : side) polygon.push_back(corner(i));
  return polygon;
}

std::array<Vec4, 6> planes_of(const Bounds& box) {
  std::array<Vec4, 6> planes{};
  for (int axis = 0; axis < 3; ++axis) {
    planes[2 * axis][axis] = 1.0;
    planes[2 * axis].w = -box.low[axis];
    planes[2 * axis + 1][axis] = -1.0;
    planes[2 * axis + 1].w = box.high[axis];
  }
  return planes;
}

}  // namespace

Frustum frustum_of(const Viewpoint& viewpoint, double aspect) {
  const Mat4 back = glm::inverse(viewpoint.view_projection(aspect));
  Frustum frustum;
  Vec3 inside(0.0);
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec4 p = back * Vec4(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : 0.0, 1.0);
    frustum.corners[i] = Vec3(p) / p.w;
    inside += frustum.corners[i] / 8.0;
  }
  for (std::size_t i = 0; i < 6; ++i)
    frustum.planes[i] =
        plane_through(frustum.corners[sides[i][0]], frustum.corners[sides[i][1]], frustum.corners[sides[i][2]], inside);
  return frustum;
}

std::vector<Vec3> clipped_polygon(std::vector<Vec3> polygon, std::span<const Vec4> planes) {
  for (const Vec4& plane : planes) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double from = height(plane, a), to = height(plane, b);
      if (from >= 0.0) kept.push_back(a);
      if ((from < 0.0) != (to < 0.0)) kept.push_back(glm::mix(a, b, from / (from - to)));
    }
    polygon = std::move(kept);
  }
  return polygon;
}

std::vector<Vec3> seen_part(const Frustum& frustum, const Bounds& box) {
  const std::array<Vec4, 6> box_planes = planes_of(box);
  std::vector<Vec3> points;
  const auto add = [&](std::vector<Vec3> polygon, std::span<const Vec4> planes) {
    const std::vector<Vec3> kept = clipped_polygon(std::move(polygon), planes);
    points.insert(points.end(), kept.begin(), kept.end());
  };
  // A corner of what two solids share lies on a side of one of them and within the other.
  for (const auto& side : sides) {
    add(side_of([&](std::size_t i) { return frustum.corners[i]; }, side), box_planes);
    add(side_of([&](std::size_t i) { return box.corner(static_cast<int>(i)); }, side), frustum.planes);
  }
  return points;
}

}  // namespace sinew
