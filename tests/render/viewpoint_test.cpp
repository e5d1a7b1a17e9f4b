#include "engine/render/viewpoint.h"

#include <gtest/gtest.h>

#include "engine/render/screen.h"

namespace sinew::test {
namespace {

Bounds box() {
  Bounds bounds;
  bounds.add({-1, 0, -3});
  bounds.add({1, 2, 3});
  return bounds;
}

/// Where a point is seen, -1 to 1, and its depth, 0 to 1.
Vec3 seen(const Viewpoint& camera, const Vec3& p, double aspect = 1.0) {
  const Vec4 clip = camera.view_projection(aspect) * Vec4(p, 1.0);
  return Vec3(clip) / clip.w;
}

TEST(ParallelRays, ShowAllDepthsAtOneSize) {
  const Viewpoint camera = look_at({0, 1, 0}, 8.0, box(), {0.0, 0.0}, Rays::parallel);
  const double near_width = seen(camera, {1, 1, 3}).x - seen(camera, {-1, 1, 3}).x;
  const double far_width = seen(camera, {1, 1, -3}).x - seen(camera, {-1, 1, -3}).x;
  EXPECT_NEAR(near_width, far_width, 1e-12);
  const Viewpoint perspective = look_at({0, 1, 0}, 8.0, box(), {0.0, 0.0});
  EXPECT_GT(seen(perspective, {1, 1, 3}).x, seen(perspective, {1, 1, -3}).x * 1.5);
  // At the target's distance both show the same.
  EXPECT_LT(glm::distance(Vec2(seen(camera, {0.7, 1.4, 0})), Vec2(seen(perspective, {0.7, 1.4, 0}))), 1e-12);
  EXPECT_LT(seen(camera, {0, 1, 3}).z, seen(camera, {0, 1, -3}).z) << "nearer is before farther";
}

TEST(ParallelRays, FrameTheBoxExactly) {
  for (const ViewDirection& direction : {ViewDirection{0, 0}, ViewDirection{35, 12}, ViewDirection{140, -50}})
    for (const double aspect : {0.5, 1.0, 2.4}) {
      const Viewpoint camera = frame_box(box(), direction, aspect, Rays::parallel);
      double reach = 0.0;
      for (int i = 0; i < 8; ++i) {
        const Vec3 at = seen(camera, box().corner(i), aspect);
        reach = std::max({reach, std::abs(at.x), std::abs(at.y)});
        EXPECT_GT(at.z, 0.0);
        EXPECT_LT(at.z, 1.0);
      }
      EXPECT_NEAR(reach, 0.92, 1e-9) << "a margin of 4 % on each side";
    }
}

TEST(ParallelRays, WhatStandsBehindTheEyeIsSeen) {
  const Viewpoint camera = look_at({0, 1, 0}, 0.5, box(), {0.0, 0.0}, Rays::parallel);
  EXPECT_GT(seen(camera, {0, 1, 3}).z, 0.0);
  const Screen screen(camera, 200, 100);
  const auto behind = screen.point({0, 1, 3}), before = screen.point({0, 1, -3});
  ASSERT_TRUE(behind && before);
  EXPECT_NEAR(behind->depth, -2.5, 1e-9) << "along the line of sight from the eye";
  EXPECT_NEAR(before->depth, 3.5, 1e-9);
  EXPECT_TRUE(screen.faces({5, 1, 0}, {0, 0, 1}));
  EXPECT_FALSE(screen.faces({5, 1, 0}, {1, 0, -0.01})) << "whatever its place";
}

}  // namespace
}  // namespace sinew::test
