#include "engine/render/frustum.h"

#include <random>

#include <gtest/gtest.h>

namespace sinew::test {
namespace {

Bounds box_of(const Vec3& low, const Vec3& high) {
  Bounds box;
  box.add(low);
  box.add(high);
  return box;
}

Bounds hull(const std::vector<Vec3>& points) {
  Bounds box;
  for (const Vec3& p : points) box.add(p);
  return box;
}

/// Looks along -z from the origin.
Viewpoint camera() {
  Viewpoint viewpoint;
  viewpoint.eye = Vec3(0.0);
  viewpoint.near_plane = 1.0;
  viewpoint.far_plane = 3.0;
  return viewpoint;
}

TEST(Frustum, ItsCornersAreThoseOfThePyramid) {
  const Frustum frustum = frustum_of(camera(), 2.0);
  const double slope = std::tan(0.5 * vertical_field_of_view_degrees * degrees_to_radians);
  for (std::size_t i = 0; i < 8; ++i) {
    const double depth = i & 4 ? 3.0 : 1.0;
    EXPECT_NEAR(frustum.corners[i].x, (i & 1 ? 2.0 : -2.0) * slope * depth, 1e-9);
    EXPECT_NEAR(frustum.corners[i].y, (i & 2 ? -1.0 : 1.0) * slope * depth, 1e-9);
    EXPECT_NEAR(frustum.corners[i].z, -depth, 1e-9);
    for (const Vec4& plane : frustum.planes) EXPECT_GE(glm::dot(plane, Vec4(frustum.corners[i], 1.0)), -1e-9);
  }
}

TEST(Frustum, SeesAllOfASmallBoxAndItselfInALargeOne) {
  const Frustum frustum = frustum_of(camera(), 1.0);
  const Bounds small = box_of({-0.1, -0.1, -2.1}, {0.1, 0.1, -1.9});
  const Bounds seen = hull(seen_part(frustum, small));
  EXPECT_LT(glm::length(seen.low - small.low) + glm::length(seen.high - small.high), 1e-12);
  const Bounds all = hull(seen_part(frustum, box_of({-9, -9, -9}, {9, 9, 9})));
  EXPECT_NEAR(all.low.z, -3.0, 1e-9);
  EXPECT_NEAR(all.high.z, -1.0, 1e-9);
  EXPECT_NEAR(all.high.x, 3.0 * std::tan(0.5 * vertical_field_of_view_degrees * degrees_to_radians), 1e-9);
  EXPECT_TRUE(seen_part(frustum, box_of({5, 5, -2}, {6, 6, -1})).empty());
  EXPECT_TRUE(seen_part(frustum, box_of({-1, -1, 1}, {1, 1, 2})).empty());
}

TEST(Frustum, HoldsWhatIsInBothAndNoMoreThanEither) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  for (int round = 0; round < 50; ++round) {
    Viewpoint viewpoint = look_at({place(generator), place(generator), place(generator)}, 2.0,
                                  box_of({-1, -1, -1}, {1, 1, 1}), {.azimuth = 60.0 * place(generator)});
    const Frustum frustum = frustum_of(viewpoint, 1.3);
    const Vec3 a(place(generator), place(generator), place(generator)),
        b(place(generator), place(generator), place(generator));
    const Bounds box = hull({a, b});
    const std::vector<Vec3> points = seen_part(frustum, box);
    for (const Vec3& p : points)
      for (const Vec4& plane : frustum.planes) EXPECT_GE(glm::dot(plane, Vec4(p, 1.0)), -1e-9);
    const Bounds seen = hull(points);
    for (int i = 0; i < 200; ++i) {
      const Vec3 p =
          glm::mix(box.low, box.high, 0.5 + 0.25 * Vec3(place(generator), place(generator), place(generator)));
      bool within = true;
      for (const Vec4& plane : frustum.planes) within = within && glm::dot(plane, Vec4(p, 1.0)) >= 0.0;
      if (!within) continue;
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(p[axis], seen.low[axis] - 1e-9);
        EXPECT_LE(p[axis], seen.high[axis] + 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
