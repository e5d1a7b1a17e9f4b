#include "engine/core/math.h"

#include <glm/gtc/matrix_transform.hpp>

namespace sinew {

Mat4 Transform::matrix() const {
  Mat4 m = glm::mat4_cast(rotation);
  m[0] *= scale.x;
  m[1] *= scale.y;
  m[2] *= scale.z;
  m[3] = Vec4(translation, 1.0);
  return m;
}

Mat34 Mat34::from(const Mat4& m) {
  const Mat4 t = glm::transpose(m);
  return {{t[0], t[1], t[2]}};
}

Vec3 Mat34::transform_point(const Vec3& p) const {
  const Vec4 q(p, 1.0);
  return {glm::dot(row[0], q), glm::dot(row[1], q), glm::dot(row[2], q)};
}

Mat3 Mat34::linear() const {
  return {{row[0].x, row[1].x, row[2].x}, {row[0].y, row[1].y, row[2].y}, {row[0].z, row[1].z, row[2].z}};
}

Quat rotation_xyz_degrees(const Vec3& degrees) {
  const Vec3 r = degrees * degrees_to_radians;
  const Quat x = glm::angleAxis(r.x, Vec3(1, 0, 0));
  const Quat y = glm::angleAxis(r.y, Vec3(0, 1, 0));
  const Quat z = glm::angleAxis(r.z, Vec3(0, 0, 1));
  return z * y * x;
}

double angle_degrees(const Vec3& a, const Vec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * radians_to_degrees;
}

Vec3 unit_or(const Vec3& v, const Vec3& fallback) {
  const double length = glm::length(v);
  return length > 1e-30 ? v / length : fallback;
}

double smoothstep01(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

double smoothstep01_slope(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return 6.0 * x * (1.0 - x);
}

Mat3 cofactor(const Mat3& a) { return {glm::cross(a[1], a[2]), glm::cross(a[2], a[0]), glm::cross(a[0], a[1])}; }

}  // namespace sinew
