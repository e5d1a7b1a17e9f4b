#include "engine/render/canvas.h"

#include <random>

#include <gtest/gtest.h>

namespace sinew {
namespace {

constexpr Colour black{0, 0, 0, 255};

Picture transparent(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height)};
}

double alpha(const Picture& picture, int x, int y) {
  return picture.rgba[(std::size_t(y) * picture.width + x) * 4 + 3] / 255.0;
}

/// The area that is covered, in pixels.
double ink(const Picture& picture) {
  double sum = 0.0;
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) sum += picture.rgba[i] / 255.0;
  return sum;
}

/// Rounding of alpha: half a level a pixel of a column that a line of `width` touches; and of corners to 1/256 pixel.
double column_tolerance(double width) { return (width + 2.0) * 0.5 / 255.0 + 1.0 / 256.0; }

TEST(Canvas, HorizontalLineCoversItsWidthInEveryColumn) {
  for (const double width : {0.3, 1.0, 1.5, 2.0, 3.7}) {
    for (const double y : {10.0, 10.25, 10.5, 10.811}) {
      Picture picture = transparent(40, 20);
      Canvas(picture).line({5.0, y}, {33.5, y}, {.colour = black, .width = width});
      for (int x = 0; x < 40; ++x) {
        double column = 0.0;
        for (int row = 0; row < 20; ++row) column += alpha(picture, x, row);
        const double part = x < 5 || x > 33 ? 0.0 : x == 33 ? 0.5 : 1.0;
        EXPECT_NEAR(column, part * width, column_tolerance(width)) << width << " at " << y << ", column " << x;
      }
    }
  }
}

TEST(Canvas, PixelsOfAHorizontalLineAreTheClosedForm) {
  const double y = 10.3, width = 2.5;
  Picture picture = transparent(8, 20);
  Canvas(picture).line({-5.0, y}, {50.0, y}, {.colour = black, .width = width});
  for (int row = 0; row < 20; ++row) {
    const double covered =
        std::clamp(std::min(row + 1.0, y + width / 2) - std::max(double(row), y - width / 2), 0.0, 1.0);
    EXPECT_NEAR(alpha(picture, 3, row), covered, 0.005) << row;
  }
}

TEST(Canvas, EveryPixelOfATriangleHasItsArea) {
  const Contour corners{{2.3, 3.1}, {27.9, 8.4}, {11.2, 18.7}};
  Picture picture = transparent(30, 22);
  Canvas(picture).polygon(corners, black);
  const auto inside = [&](const Vec2& p) {
    bool all = true;
    for (int i = 0; i < 3; ++i) {
      const Vec2 edge = corners[(i + 1) % 3] - corners[i], to = p - corners[i];
      all = all && edge.x * to.y - edge.y * to.x > 0.0;
    }
    return all;
  };
  constexpr int samples = 64;
  for (int y = 0; y < 22; ++y) {
    for (int x = 0; x < 30; ++x) {
      int hits = 0;
      for (int i = 0; i < samples * samples; ++i)
        if (inside(Vec2(x, y) + (Vec2(i % samples, i / samples) + 0.5) / double(samples))) ++hits;
      // An edge may pass through all samples of a row or column.
      ASSERT_NEAR(alpha(picture, x, y), double(hits) / (samples * samples), 1.5 / samples) << x << " " << y;
    }
  }
}

TEST(Canvas, ALineHasTheSameInkInEveryDirection) {
  for (const Cap cap : {Cap::butt, Cap::round}) {
    const double expected = 60.0 * 1.5 + (cap == Cap::round ? std::numbers::pi * 0.75 * 0.75 : 0.0);
    for (int degrees = 0; degrees < 180; degrees += 7) {
      Picture picture = transparent(80, 80);
      const double a = degrees * degrees_to_radians;
      const Vec2 centre(40.2, 39.7), half = 30.0 * Vec2(std::cos(a), std::sin(a));
      Canvas(picture).line(centre - half, centre + half, {.colour = black, .width = 1.5, .cap = cap});
      // Corners lie on a grid of 1/256: at most 0.5 % of the width.
      EXPECT_NEAR(ink(picture), expected, 0.007 * expected) << degrees;
    }
  }
}

TEST(Canvas, AreaOfDiscsAndEllipses) {
  for (const double radius : {0.7, 1.5, 3.4, 10.0, 33.3}) {
    Picture picture = transparent(80, 80);
    Canvas(picture).disc({40.3, 39.6}, radius, black);
    const double expected = std::numbers::pi * radius * radius;
    EXPECT_NEAR(ink(picture), expected, 0.01 * expected) << radius;
  }
  Picture picture = transparent(80, 80);
  Canvas(picture).filled_ellipse({40.0, 40.0}, {30.0, 8.0}, 33.0, black);
  EXPECT_NEAR(ink(picture), std::numbers::pi * 240.0, 0.01 * std::numbers::pi * 240.0);
}

TEST(Canvas, OutlinesHaveTheInkOfTheirLength) {
  Picture picture = transparent(80, 80);
  Canvas canvas(picture);
  canvas.circle({40.0, 40.0}, 25.0, {.colour = black, .width = 1.5});
  EXPECT_NEAR(ink(picture), 2.0 * std::numbers::pi * 25.0 * 1.5, 1.0);

  picture = transparent(80, 80);
  const Vec2 square[] = {{10, 10}, {60, 10}, {60, 60}, {10, 60}};
  canvas.polyline(square, {.colour = black, .width = 2.0}, true);
  EXPECT_NEAR(ink(picture), 52.0 * 52.0 - 48.0 * 48.0, 0.1);
}

TEST(Canvas, DashesAndGapsShareALine) {
  for (const double start : {5.0, -1003.0}) {
    Picture picture = transparent(120, 20);
    Canvas(picture).line({start, 10.0}, {105.0, 10.0}, {.colour = black, .width = 2.0, .dash = 6.0, .gap = 4.0});
    for (int x = std::max(int(start), 0); x < 105; ++x) {
      const bool dash = std::fmod(x - start, 10.0) < 5.5;
      EXPECT_NEAR(alpha(picture, x, 10), dash ? 1.0 : 0.0, 0.01) << x;
    }
  }
}

TEST(Canvas, ADashGoesRoundACorner) {
  Picture picture = transparent(40, 40);
  const Vec2 corner[] = {{5, 10}, {20, 10}, {20, 35}};
  Canvas(picture).polyline(corner, {.colour = black, .width = 2.0, .dash = 20.0, .gap = 50.0});
  EXPECT_NEAR(ink(picture), 40.0, 0.2);
  EXPECT_NEAR(alpha(picture, 20, 9), 1.0, 0.01) << "the mitre";
  EXPECT_NEAR(alpha(picture, 20, 17), 0.0, 0.01);
}

TEST(Canvas, ATranslucentStrokeIsNotDrawnTwiceWhereItCrossesItself) {
  Picture picture = transparent(60, 60);
  std::vector<Vec2> zigzag{{5, 5}, {50, 50}, {50, 5}, {5, 50}, {6, 8}, {55, 9}};
  Canvas(picture).polyline(zigzag, {.colour = {0, 0, 0, 100}, .width = 5.0});
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) ASSERT_LE(picture.rgba[i], 100);
  EXPECT_EQ(picture.rgba[(27 * 60 + 27) * 4 + 3], 100);
}

TEST(Canvas, ContoursUniteAndOppositeOnesCutHoles) {
  const Contour outer{{10, 10}, {30, 10}, {30, 30}, {10, 30}}, shifted{{20, 20}, {40, 20}, {40, 40}, {20, 40}};
  Contour hole{{15, 15}, {25, 15}, {25, 25}, {15, 25}};
  std::reverse(hole.begin(), hole.end());
  Picture both = transparent(50, 50), ring = transparent(50, 50);
  const Contour united[] = {outer, shifted}, cut[] = {outer, hole};
  Canvas(both).fill(united, black);
  Canvas(ring).fill(cut, black);
  EXPECT_DOUBLE_EQ(ink(both), 700.0);
  EXPECT_DOUBLE_EQ(ink(ring), 300.0);
}

TEST(Canvas, LargePicturesAreTheSameAsSmallOnes) {
  // Wider than one band of the rasteriser, so that shapes are cut into several.
  Picture picture = transparent(3000, 1200);
  Canvas(picture).disc({1500.0, 600.0}, 590.0, black);
  Canvas(picture).line({0.0, 0.0}, {3000.0, 0.5}, {.colour = black, .width = 1.0});
  EXPECT_NEAR(ink(picture), std::numbers::pi * 590.0 * 590.0 + 3000.0 * 0.75, 300.0);
}

TEST(Canvas, ArrowEndsAtItsPointWithAWideHead) {
  Picture picture = transparent(60, 30);
  Canvas(picture).arrow({5.0, 15.0}, {50.0, 15.0}, {.colour = black, .width = 2.0}, 12.0);
  EXPECT_GT(alpha(picture, 48, 15), 0.3);
  EXPECT_EQ(alpha(picture, 50, 15), 0.0);
  EXPECT_GT(alpha(picture, 39, 18), 0.9) << "head";
  EXPECT_EQ(alpha(picture, 30, 18), 0.0) << "shaft";
  EXPECT_NEAR(ink(picture), 33.0 * 2.0 + 0.42 * 12.0 * 12.0, 0.5);
}

TEST(Canvas, RoundedBoxLeavesItsCorners) {
  Picture picture = transparent(60, 40);
  Canvas(picture).rounded_box({{10, 10}, {50, 30}}, 6.0, black);
  EXPECT_EQ(alpha(picture, 10, 10), 0.0);
  EXPECT_EQ(alpha(picture, 30, 10), 1.0);
  EXPECT_NEAR(ink(picture), 800.0 - (4.0 - std::numbers::pi) * 36.0, 0.5);
}

/// "Over" with straight alpha as the textbook has it.
Vec4 over(const Vec4& top, const Vec4& bottom) {
  const double a = top.a + bottom.a * (1.0 - top.a);
  if (a == 0.0) return bottom;
  const Vec3 colour = (Vec3(top) * top.a + Vec3(bottom) * bottom.a * (1.0 - top.a)) / a;
  return Vec4(colour, a);
}

TEST(Canvas, CompositesAsTheFormulaSays) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> byte(0, 255);
  for (int i = 0; i < 2000; ++i) {
    std::uint8_t b[8];
    for (std::uint8_t& value : b) value = static_cast<std::uint8_t>(byte(random));
    if (i % 4 == 0) b[7] = 0;
    if (i % 4 == 1) b[7] = 255;
    const int quarters = i % 5;  // of the pixel are covered
    Picture picture{1, 1, {b[4], b[5], b[6], b[7]}};
    Canvas(picture).polygon({{0, 0}, {0.25 * quarters, 0}, {0.25 * quarters, 1}, {0, 1}}, {b[0], b[1], b[2], b[3]});
    const Vec4 top(b[0], b[1], b[2], b[3] / 255.0 * 0.25 * quarters), bottom(b[4], b[5], b[6], b[7] / 255.0);
    const Vec4 expected = over(top, bottom);
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(picture.rgba[c], expected[c], 0.5 + 1e-9) << i;
    ASSERT_NEAR(picture.rgba[3], 255.0 * expected.a, 0.5 + 1e-9) << i;
  }
}

TEST(Canvas, ColourOfTransparentPixelsDoesNotShineThrough) {
  Picture picture{1, 1, {200, 100, 50, 0}};
  Canvas(picture).polygon({{0, 0}, {1, 0}, {1, 0.5}, {0, 0.5}}, {10, 20, 30, 255});
  EXPECT_EQ(picture.rgba, (std::vector<std::uint8_t>{10, 20, 30, 128}));
}

void draw_everything(Canvas& canvas, const Vec2& a, const Vec2& b, double size) {
  const Stroke stroke{.colour = black, .width = 2.0}, dashed{.colour = black, .width = 2.0, .dash = 3.0, .gap = 2.0};
  canvas.line(a, b, stroke);
  canvas.line(a, b, dashed);
  const Vec2 points[] = {a, b, {5.0, 5.0}, a};
  canvas.polyline(points, stroke, true);
  canvas.polyline(points, dashed, true);
  canvas.polygon({a, b, {size, 3.0}}, black);
  canvas.arrow(a, b, stroke, size);
  canvas.disc(a, size, black);
  canvas.circle(b, size, stroke);
  canvas.ellipse(a, {size, 2.0}, size, dashed);
  canvas.rounded_box({a, b}, size, black, stroke);
  canvas.line(a, b, {.colour = black, .width = size, .dash = size, .gap = size});
  (void)canvas.brightness({a, b});
  (void)mask_of(std::vector<Contour>{{a, b, {size, 3.0}}});
}

TEST(Canvas, AnythingMayLieOutside) {
  const double numbers[] = {0.0,     -7.0,     20.0,   1e5,      -1e9,      1e30,       -1e200,
                            1.7e308, -1.7e308, 1e-320, INFINITY, -INFINITY, double(NAN)};
  for (const double x : numbers) {
    for (const double y : numbers) {
      Picture picture = transparent(30, 20);
      Canvas canvas(picture);
      draw_everything(canvas, {x, y}, {y, 12.0}, x);
      draw_everything(canvas, {x, y}, {-x, -y}, y);
    }
  }
  Picture empty;
  Canvas canvas(empty);
  draw_everything(canvas, {1.0, 2.0}, {30.0, 4.0}, 5.0);
}

TEST(Canvas, WhatIsNotFiniteIsNotDrawn) {
  for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY)}) {
    Picture picture = transparent(30, 20);
    Canvas canvas(picture);
    draw_everything(canvas, {bad, 10.0}, {bad, 12.0}, bad);
    EXPECT_EQ(ink(picture), 0.0);
  }
}

TEST(Canvas, EndlessLinesAreRightWhereTheyAreSeen) {
  Picture near_line = transparent(30, 20), far_line = transparent(30, 20), filled = transparent(30, 20);
  Canvas(near_line).line({-50.0, 10.25}, {90.0, 10.25}, {.colour = black, .width = 1.5});
  Canvas(far_line).line({-1e15, 10.25}, {1e15, 10.25}, {.colour = black, .width = 1.5});
  Canvas(filled).polygon({{-1e20, -1e20}, {1e20, -1e20}, {1e20, 1e20}, {-1e20, 1e20}}, black);
  EXPECT_EQ(near_line.rgba, far_line.rgba);
  EXPECT_DOUBLE_EQ(ink(filled), 600.0);
}

TEST(Canvas, AShapeCutByTheEdgeIsTheShapeCut) {
  Picture whole = transparent(100, 100), part = transparent(30, 40);
  const Contour star{{50, 5}, {65, 90}, {8, 35}, {93, 31}, {30, 92}};
  const auto shifted = [&](const Vec2& by) {
    Contour result = star;
    for (Vec2& p : result) p += by;
    return result;
  };
  Canvas(whole).polygon(star, black);
  Canvas(part).polygon(shifted({-40.0, -45.0}), black);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 30; ++x) ASSERT_NEAR(alpha(part, x, y), alpha(whole, x + 40, y + 45), 2.1 / 255.0);
}

TEST(Canvas, TheSameCallsGiveTheSameBytes) {
  const auto draw = [] {
    Picture picture = transparent(90, 70);
    Canvas canvas(picture);
    draw_everything(canvas, {3.3, 9.1}, {77.7, 51.2}, 13.7);
    return picture.rgba;
  };
  EXPECT_EQ(draw(), draw());
}

TEST(Canvas, ADilatedMaskReachesItsRadius) {
  const Contour square[] = {{{10, 10}, {20, 10}, {20, 20}, {10, 20}}};
  const Mask grown = dilated(mask_of(square), 3.0);
  Picture picture = transparent(40, 40);
  Canvas(picture).stamp(grown, black);
  EXPECT_EQ(alpha(picture, 15, 15), 1.0);
  EXPECT_GT(alpha(picture, 7, 15), 0.4);
  EXPECT_EQ(alpha(picture, 5, 15), 0.0);
  EXPECT_LT(alpha(picture, 7, 7), 0.1) << "round at the corners";
}

TEST(Canvas, BrightnessIsThatOfThePixelsUnderTheBox) {
  Picture picture = transparent(10, 10);
  Canvas canvas(picture);
  canvas.polygon({{0, 0}, {5, 0}, {5, 10}, {0, 10}}, black);
  EXPECT_NEAR(*canvas.brightness({{0, 0}, {5, 10}}), 0.0, 1e-9);
  EXPECT_NEAR(*canvas.brightness({{0, 0}, {10, 10}}), 0.5 * 216.0 / 255.0, 1e-9);
  EXPECT_FALSE(canvas.brightness({{20, 0}, {30, 10}}));
}

}  // namespace
}  // namespace sinew
