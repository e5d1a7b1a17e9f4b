#pragma once
/// Linear algebra used everywhere: GLM, column vectors, right-handed, double precision unless the name ends in `f`.
/// The device computes in float; everything that is measured against it computes in double.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace sinew {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;
using Quat = glm::dquat;
using Vec2f = glm::fvec2;
using Vec3f = glm::fvec3;
using Vec4f = glm::fvec4;
using Mat4f = glm::fmat4;

constexpr double degrees_to_radians = std::numbers::pi / 180.0;
constexpr double radians_to_degrees = 180.0 / std::numbers::pi;

/// Translation after rotation after scale, as a glTF node stores it.
struct Transform {
  Vec3 translation{0.0};
  Quat rotation{1.0, 0.0, 0.0, 0.0};  ///< w, x, y, z; unit length
  Vec3 scale{1.0};

  Mat4 matrix() const;
};

/// The affine part of a 4x4 matrix as three rows of four: what the skin's palette is made of.
struct Mat34 {
  Vec4 row[3] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};

  static Mat34 from(const Mat4& m);
  Vec3 transform_point(const Vec3& p) const;
  Mat3 linear() const;  ///< the 3x3 part, column-major as GLM stores it
};

/// Turn about the model's x, y and z axes by the given degrees, x first, then y, then z: R = Rz Ry Rx.
Quat rotation_xyz_degrees(const Vec3& degrees);

/// The angle between two directions of any length, in degrees, 0 to 180; accurate near both ends.
double angle_degrees(const Vec3& a, const Vec3& b);

/// v / |v|, or `fallback` where v is too short to have a direction.
Vec3 unit_or(const Vec3& v, const Vec3& fallback);

/// Hermite step 3x^2 - 2x^3 of x clamped to 0..1.
double smoothstep01(double x);

/// Derivative of smoothstep01: 6x(1 - x) inside 0..1 and 0 outside.
double smoothstep01_slope(double x);

/// Cofactor matrix of A: det(A) A^-T, defined for singular matrices as well.
Mat3 cofactor(const Mat3& a);

/// Axis-aligned box; empty until a point is added.
struct Bounds {
  Vec3 low{INFINITY};
  Vec3 high{-INFINITY};

  void add(const Vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void add(const Bounds& b) {
    low = glm::min(low, b.low);
    high = glm::max(high, b.high);
  }
  bool empty() const { return low.x > high.x; }
  Vec3 centre() const { return 0.5 * (low + high); }
  /// One of the eight corners: bits 0, 1 and 2 of `i` choose the high end of x, y and z.
  Vec3 corner(int i) const { return {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}; }
  double diagonal() const { return empty() ? 0.0 : glm::length(high - low); }
};

}  // namespace sinew
