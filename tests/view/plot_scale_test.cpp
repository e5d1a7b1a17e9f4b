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

TEST(RoundStep, Is125AndNeverTooFine) {
  for (double length = 0.003; length < 5000.0; length *= 1.37)
    for (const int most : {2, 5, 11}) {
      const double step = round_step(length, most);
      EXPECT_LE(length / step, most * (1.0 + 1e-6));
      EXPECT_GE(length / step, most / 2.5 * (1.0 - 1e-6)) << "the next finer one would be too fine";
      const double digit = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
      EXPECT_TRUE(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6) << step;
    }
}

}  // namespace
}  // namespace sinew::test
