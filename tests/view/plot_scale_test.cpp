#include "engine/view/plot_scale.h"

#include <gtest/gtest.h>

namespace sinew::test {
namespace {

TEST(PlotScale, GoesToPixelsAndBack) {
  const PlotScale scale{{0.0, 4.0}, {-90.0, 30.0}, {50.0, 20.0}, {400.0, 240.0}};
  EXPECT_EQ(scale.to_pixel(0.0, 30.0), Vec2(50.0, 20.0)) << "the upper left corner";
  EXPECT_EQ(scale.to_pixel(4.0, -90.0), Vec2(450.0, 260.0));
  const Vec2 at = scale.to_pixel(1.3, -12.0);
  EXPECT_NEAR(scale.x_of(at.x), 1.3, 1e-12);
  EXPECT_NEAR(scale.y_of(at.y), -12.0, 1e-12);
  // A slope in pixels is the way between two points of the line.
  const Vec2 on = scale.to_pixel(2.3, -12.0 + 7.0);
  EXPECT_NEAR(scale.pixel_slope(7.0), (on.y - at.y) / (on.x - at.x), 1e-12);
  EXPECT_NEAR(scale.slope_of(scale.pixel_slope(7.0)), 7.0, 1e-12);
}

TEST(PlotRange, IsNeverEmpty) {
  EXPECT_GT(PlotRange{}.widened(0.1, 1.0).length(), 0.0);
  PlotRange range;
  range.add(5.0);
  const PlotRange wide = range.widened(0.1, 2.0);
  EXPECT_DOUBLE_EQ(wide.low, 4.0);
  EXPECT_DOUBLE_EQ(wide.high, 6.0);
  range.add(25.0);
  EXPECT_DOUBLE_EQ(range.widened(0.1, 2.0).low, 3.0);
}

}  // namespace
}  // namespace sinew::test
