#include "engine/view/orbit_camera.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

/// Degrees that the camera turns when the pointer goes across the picture's height.
constexpr double turn = 220.0;
constexpr double nearer_a_step = 0.9;
constexpr double shortest = 1e-4, longest = 1e6;

}  // namespace

OrbitCamera OrbitCamera::of(const FrameMaker& maker, int frame, double aspect) {
  const CameraPlace place = maker.camera_place(frame);
  OrbitCamera out{place.direction, {}, 1.0, place.rays};
  out.frame(maker.bounds(), aspect);
  if (place.target) out.target = *place.target;
  if (place.distance) out.distance = *place.distance;
  return out;
}

void OrbitCamera::frame(const Bounds& box, double aspect) {
  target = box.centre();
  distance = std::clamp(glm::length(frame_box(box, direction, aspect, rays).eye - target), shortest, longest);
}

void OrbitCamera::frame(const Vec3& centre, double reach, double aspect) {
  target = centre;
  distance = std::clamp(2.0 * reach / seen_height(1.0) / std::min(aspect, 1.0), shortest, longest);
}

void OrbitCamera::orbit(double across, double down) {
  direction.azimuth = std::remainder(direction.azimuth - turn * across, 360.0);
  direction.elevation = std::clamp(direction.elevation + turn * down, -90.0, 90.0);
}

void OrbitCamera::pan(double across, double down) {
  Bounds point;
  point.add(target);
  const Viewpoint camera = look_at(target, distance, point, direction);
  const double height = seen_height(distance);
  target += height * (down * camera.up - across * camera.right);
}

void OrbitCamera::zoom(double steps) {
  distance = std::clamp(distance * std::pow(nearer_a_step, steps), shortest, longest);
}

Camera OrbitCamera::camera() const {
  Camera camera;
  if (rays == Rays::parallel) camera.projection = Projection::orthographic;
  camera.orbit = Keyed<double>::constant(direction.azimuth);
  camera.elevation = direction.elevation;
  camera.target = Keyed<Vec3>::constant(target);
  camera.distance = Keyed<double>::constant(distance);
  return camera;
}

}  // namespace sinew
