#include "engine/render/viewpoint.h"

namespace sinew {
namespace {

constexpr double margin = 0.04;

Viewpoint oriented(const ViewDirection& direction) {
  const double a = direction.azimuth * degrees_to_radians, e = direction.elevation * degrees_to_radians;
  Viewpoint camera;
  camera.right = {std::cos(a), 0.0, -std::sin(a)};
  camera.back = {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
  camera.up = glm::cross(camera.back, camera.right);
  return camera;
}

}  // namespace

double seen_height(double distance) {
  return 2.0 * distance * std::tan(0.5 * vertical_field_of_view_degrees * degrees_to_radians);
}

Mat4 Viewpoint::view_projection(double aspect) const {
  Mat4 view(1.0);
  for (int i = 0; i < 3; ++i) {
    view[i][0] = right[i];
    view[i][1] = up[i];
    view[i][2] = back[i];
  }
  view[3] = Vec4(-glm::dot(right, eye), -glm::dot(up, eye), -glm::dot(back, eye), 1.0);
  if (is_parallel()) {
    Mat4 projection(1.0);
    projection[0][0] = 2.0 / (parallel_height * aspect);
    projection[1][1] = -2.0 / parallel_height;
    projection[2][2] = 1.0 / (near_plane - far_plane);
    projection[3][2] = near_plane / (near_plane - far_plane);
    return projection * view;
  }
  const double scale = 1.0 / std::tan(0.5 * vertical_field_of_view_degrees * degrees_to_radians);
  Mat4 projection(0.0);
  projection[0][0] = scale / aspect;
  projection[1][1] = -scale;
  projection[2][2] = far_plane / (near_plane - far_plane);
  projection[2][3] = -1.0;
  projection[3][2] = near_plane * far_plane / (near_plane - far_plane);
  return projection * view;
}

double Viewpoint::height_at(const Vec3& p) const {
  return is_parallel() ? parallel_height : seen_height(glm::dot(eye - p, back));
}

Viewpoint look_at(const Vec3& target, double distance, const Bounds& box, const ViewDirection& direction, Rays rays) {
  Viewpoint camera = oriented(direction);
  camera.eye = target + distance * camera.back;
  double nearest = INFINITY, farthest = -INFINITY;
  for (int i = 0; i < 8; ++i) {
    const double depth = glm::dot(camera.eye - box.corner(i), camera.back);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  // Half a box more on either side: a bulge, a strand of hair or an unsampled frame may leave the box.
  const double slack = 0.5 * box.diagonal() + 1e-9;
  if (rays == Rays::parallel) {
    // What stands beside or behind the eye is seen too.
    camera.parallel_height = seen_height(distance);
    camera.near_plane = nearest - slack;
    camera.far_plane = farthest + slack;
    return camera;
  }
  camera.far_plane = std::max(farthest, distance) + slack;
  camera.near_plane = std::max(nearest - slack, camera.far_plane * 1e-3);
  return camera;
}

Viewpoint frame_box(const Bounds& box, const ViewDirection& direction, double aspect, Rays rays) {
  const Viewpoint axes = oriented(direction);
  const double slope_y = (1.0 - 2.0 * margin) * std::tan(0.5 * vertical_field_of_view_degrees * degrees_to_radians);
  const double slope_x = slope_y * aspect;
  double distance = 1e-6;
  for (int i = 0; i < 8; ++i) {
    const Vec3 p = box.corner(i) - box.centre();
    const double depth = rays == Rays::parallel ? 0.0 : glm::dot(p, axes.back);
    distance = std::max({distance, depth + std::abs(glm::dot(p, axes.right)) / slope_x,
                         depth + std::abs(glm::dot(p, axes.up)) / slope_y});
  }
  return look_at(box.centre(), distance, box, direction, rays);
}

}  // namespace sinew
