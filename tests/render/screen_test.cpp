#include "engine/render/screen.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

constexpr int width = 640, height = 480;

Viewpoint front_view() {
  Bounds box;
  box.add(Vec3(-1.0));
  box.add(Vec3(1.0));
  return look_at(Vec3(0.0), 6.0, box, {0.0, 0.0});
}

TEST(Screen, ProjectsLikeTheViewpoint) {
  const Viewpoint view = front_view();
  const Screen screen(view, width, height);
  const auto centre = screen.point(Vec3(0.0));
  ASSERT_TRUE(centre);
  EXPECT_NEAR(centre->at.x, 320.0, 1e-9);
  EXPECT_NEAR(centre->at.y, 240.0, 1e-9);
  EXPECT_NEAR(centre->depth, 6.0, 1e-9);
  // Half the picture's height is depth x tan(15 degrees).
  const auto up = screen.point({0.0, 6.0 * std::tan(15.0 * degrees_to_radians), 0.0});
  ASSERT_TRUE(up);
  EXPECT_NEAR(up->at.y, 0.0, 1e-9);
}

TEST(Screen, CutsOffAtTheNearPlane) {
  const Viewpoint view = front_view();
  const Screen screen(view, width, height);
  const Vec3 behind(0.5, 0.5, 20.0), before(0.0, 0.0, 0.0), also_behind(3.0, 0.0, 8.0);
  EXPECT_FALSE(screen.point(behind));
  EXPECT_FALSE(screen.segment(behind, also_behind));
  for (const bool reversed : {false, true}) {
    const auto seen = reversed ? screen.segment(behind, before) : screen.segment(before, behind);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(std::min(seen->first.depth, seen->second.depth), view.near_plane, 1e-9);
    EXPECT_NEAR(std::max(seen->first.depth, seen->second.depth), 6.0, 1e-9);
    const Vec3 crossing = before + (6.0 - view.near_plane) / 20.0 * (behind - before);
    const auto expected = screen.point(crossing - Vec3(0, 0, 1e-9));
    ASSERT_TRUE(expected);
    EXPECT_LT(glm::distance((reversed ? seen->first : seen->second).at, expected->at), 1e-3);
  }
  const Vec3 quad[] = {{-1, -1, 0}, {1, -1, 0}, {1, -1, 20}, {-1, -1, 20}};
  const Contour cut = screen.polygon(quad);
  EXPECT_EQ(cut.size(), 4u);
  for (const Vec2& p : cut) EXPECT_GE(p.y, 240.0);
  const Vec3 hidden[] = {{-1, -1, 10}, {1, -1, 10}, {1, -1, 20}};
  EXPECT_TRUE(screen.polygon(hidden).empty());
  EXPECT_FALSE(screen.point(Vec3(NAN)));
  EXPECT_FALSE(screen.segment(Vec3(0.0), Vec3(INFINITY)));
}

}  // namespace
}  // namespace sinew
