#include "engine/render/plot.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

Font any_font() {
  auto font = Font::find();
  if (!font) throw std::runtime_error(font.error().message);
  return std::move(*font);
}

/// One curve from the lower left to the upper right corner, red and nothing else is.
Plot diagonal() {
  Plot plot;
  plot.x = {"", 0.0, 10.0, 5.0};
  plot.y = {"", 0.0, 1.0, 0.5};
  plot.curves = {{"", {{0.0, 0.0}, {10.0, 1.0}}, {255, 0, 0}, false}};
  return plot;
}

Picture drawn(const Plot& plot, int width = 400, int height = 300) {
  const Font font = any_font();
  auto picture = draw_plot(plot, width, height, font);
  if (!picture) {
    ADD_FAILURE() << picture.error().message;
    return {};
  }
  return std::move(*picture);
}

/// The box of the pixels that are plainly red.
struct Red {
  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1, count = 0;
  int top_x = 0;  ///< of the uppermost
};

Red red_of(const Picture& picture) {
  Red red;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const std::uint8_t* p = &picture.rgba[(std::size_t(y) * picture.width + x) * 4];
      if (p[0] < 200 || p[1] > 60 || p[2] > 60) continue;
      if (y < red.top) red.top_x = x;
      red.left = std::min(red.left, x);
      red.right = std::max(red.right, x);
      red.top = std::min(red.top, y);
      red.bottom = std::max(red.bottom, y);
      ++red.count;
    }
  return red;
}

TEST(Plot, ACurveGoesWhereTheAxesSay) {
  const Red rising = red_of(drawn(diagonal()));
  EXPECT_GT(rising.count, 200);
  EXPECT_GT(rising.top_x, 200);
  Plot turned = diagonal();
  std::swap(turned.x.first, turned.x.last);
  const Red falling = red_of(drawn(turned));
  EXPECT_LT(falling.top_x, 200);
  // The same box, mirrored: the corners of the axes, whose lines hide the curve's ends by a pixel or two.
  EXPECT_NEAR(falling.left, rising.left, 3);
  EXPECT_NEAR(falling.right, rising.right, 3);
  Plot half = diagonal();
  half.y.last = 2.0;
  const Red flat = red_of(drawn(half));
  EXPECT_NEAR(flat.bottom - flat.top, 0.5 * (rising.bottom - rising.top), 4);
}

TEST(Plot, WhatLiesBeyondTheAxisIsLeftOut) {
  Plot plot = diagonal();
  plot.curves[0].points = {{-5.0, 0.5}, {0.0, 0.5}, {5.0, 0.5}, {50.0, 0.5}};
  const Red red = red_of(drawn(plot)), whole = red_of(drawn(diagonal()));
  EXPECT_NEAR(red.left, whole.left, 3);
  EXPECT_LT(red.right, 0.6 * whole.right + 0.4 * whole.left + 5);
}

TEST(Plot, StepsAreRound) {
  EXPECT_DOUBLE_EQ(round_step(1.0, 5), 0.2);
  EXPECT_DOUBLE_EQ(round_step(12.0, 5), 2.0);
  EXPECT_DOUBLE_EQ(round_step(300.0, 6), 50.0);
  EXPECT_DOUBLE_EQ(round_step(0.9, 1), 1.0);
}

TEST(Plot, RefusesWhatCannotBeDrawn) {
  const Font font = any_font();
  Plot empty = diagonal();
  empty.x.last = empty.x.first;
  EXPECT_FALSE(draw_plot(empty, 400, 300, font));
  Plot stepless = diagonal();
  stepless.y.step = 0.0;
  EXPECT_FALSE(draw_plot(stepless, 400, 300, font));
  EXPECT_FALSE(draw_plot(diagonal(), 40, 300, font));
}

}  // namespace
}  // namespace sinew
