#include "engine/render/flip.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace sinew {
namespace {

using Rgb = std::array<int, 3>;

template <class Colour>
Picture painted(int width, int height, const Colour& colour) {
  Picture picture{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Rgb rgb = colour(x, y);
      for (const int channel : rgb)
        picture.rgba.push_back(static_cast<std::uint8_t>(std::min(std::max(channel, 0), 255)));
      picture.rgba.push_back(255);
    }
  return picture;
}

Picture flat(const Rgb& colour) {
  return painted(40, 30, [&](int, int) { return colour; });
}

double mean_flip(const Picture& a, const Picture& b) {
  const auto map = flip(a, b);
  EXPECT_TRUE(map) << map.error().message;
  if (!map) return NAN;
  for (const float error : map->errors) EXPECT_TRUE(error >= 0.0f && error <= 1.0f) << error;
  return map->mean();
}

/// Bars, rings and a colour ramp, integers only: the same in any language.
Picture pattern(int shift) {
  return painted(96, 64, [&](int x, int y) {
    const int u = x + shift, ring = (u - 48) * (u - 48) + (y - 32) * (y - 32);
    if (ring < 300) return Rgb{200, 60 + y, 40};
    if (u / 6 % 2 == 0 && y < 20) return Rgb{20, 20, 20};
    return Rgb{u * 2 % 256, 120, 255 - u * 2 % 256};
  });
}

Picture noise(unsigned seed) {
  std::mt19937 random(seed);
  return painted(96, 64, [&](int, int) { return Rgb{int(random() % 256), int(random() % 256), int(random() % 256)}; });
}

/// A flat picture has no features and is what filters leave it: its error is that of its one pair of colours.
double flat_error(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  const auto distance = [](const auto& p, const auto& q) {
    const auto dl = std::abs(p[0] - q[0]);
    const auto da = 0.01 * (p[0] * p[1] - q[0] * q[1]), db = 0.01 * (p[0] * p[2] - q[0] * q[2]);
    return std::pow(dl + std::sqrt(da * da + db * db), 0.7);
  };
  // CIELAB of sRGB's green and blue, as tables of colour science have them.
  const std::array<double, 3> green{87.7347, -86.1827, 83.1793}, blue{32.2970, 79.1875, -107.8602};
  const double largest = distance(green, blue), share = distance(a, b) / largest;
  return share < 0.4 ? share * 0.95 / 0.4 : 0.95 + (share - 0.4) / 0.6 * 0.05;
}

TEST(Flip, EqualPicturesDoNotDiffer) {
  for (const Picture& picture : {pattern(0), noise(1), flat({0, 0, 0}), flat({12, 200, 77})})
    EXPECT_EQ(mean_flip(picture, picture), 0.0);
}

TEST(Flip, OrderDoesNotMatter) {
  EXPECT_DOUBLE_EQ(mean_flip(pattern(0), pattern(3)), mean_flip(pattern(3), pattern(0)));
  EXPECT_DOUBLE_EQ(mean_flip(noise(1), noise(2)), mean_flip(noise(2), noise(1)));
}

TEST(Flip, FlatPicturesHaveTheErrorOfTheirColours) {
  // CIELAB (D65) of the colours, from tables; single precision planes and tables of four decimals agree to 1e-4.
  const std::array<double, 3> black{0, 0, 0}, white{100, 0, 0}, red{53.2408, 80.0925, 67.2032},
      yellow{97.1393, -21.5537, 94.4780}, grey{53.5850, 0, 0};
  EXPECT_NEAR(mean_flip(flat({0, 0, 0}), flat({255, 255, 255})), flat_error(black, white), 1e-4);
  EXPECT_NEAR(flat_error(black, white), 0.967, 1e-3);
  EXPECT_NEAR(mean_flip(flat({255, 0, 0}), flat({0, 0, 0})), flat_error(red, black), 1e-4);
  EXPECT_NEAR(mean_flip(flat({255, 255, 0}), flat({255, 0, 0})), flat_error(yellow, red), 1e-4);
  EXPECT_NEAR(mean_flip(flat({128, 128, 128}), flat({255, 0, 0})), flat_error(grey, red), 1e-4);
  EXPECT_NEAR(mean_flip(flat({0, 255, 0}), flat({0, 0, 255})), 1.0, 1e-6) << "no two colours lie farther apart";
}

TEST(Flip, GrowsWithTheError) {
  double before = 0.0;
  for (const int levels : {2, 5, 10, 20, 40, 80}) {
    const Picture changed = painted(40, 30, [&](int, int) { return Rgb{100 + levels, 100, 100}; });
    const double now = mean_flip(flat({100, 100, 100}), changed);
    EXPECT_GT(now, before) << levels;
    before = now;
  }
  before = 0.0;
  for (const int shift : {1, 2, 4}) {
    const double now = mean_flip(pattern(0), pattern(shift));
    EXPECT_GT(now, before) << shift;
    before = now;
  }
}

TEST(Flip, IsWhatDirectConvolutionInDoublePrecisionGives) {
  // A second program, with the whole two-dimensional kernels of the paper instead of their separable parts, gave these.
  // Planes in single precision and the white point's last digits leave some 1e-5.
  EXPECT_NEAR(mean_flip(pattern(0), pattern(3)), 0.275532, 1e-4);
  EXPECT_NEAR(mean_flip(pattern(0), pattern(1)), 0.139162, 1e-4);
  const auto map = flip(pattern(0), pattern(3));
  ASSERT_TRUE(map);
  EXPECT_NEAR(map->errors[32 * 96 + 30], 0.527387, 2e-4);
  EXPECT_NEAR(*std::max_element(map->errors.begin(), map->errors.end()), 0.969467, 2e-4);
}

TEST(Flip, AnEdgeThatMovesWeighsMoreThanItsColours) {
  const auto step = [](int at) {
    return painted(96, 64, [&](int x, int) { return x < at ? Rgb{60, 60, 60} : Rgb{180, 180, 180}; });
  };
  const auto map = flip(step(48), step(50));
  ASSERT_TRUE(map);
  EXPECT_EQ(map->errors[0], 0.0f) << "far from the edge nothing changed";
  EXPECT_GT(map->errors[32 * 96 + 48], 0.3f);
}

TEST(Flip, WhatIsTooFineForTheEyeIsNotSeenAsAColour) {
  // A checkerboard of single pixels, 67 to the degree, and its inverse: the eye sees the same grey.
  const auto board = [](int odd) {
    return painted(96, 64, [&](int x, int y) { return (x + y) % 2 == odd ? Rgb{90, 90, 90} : Rgb{160, 160, 160}; });
  };
  EXPECT_LT(mean_flip(board(0), board(1)), 0.25 * mean_flip(flat({90, 90, 90}), flat({160, 160, 160})));
  const auto near = flip(board(0), board(1), 5.0);
  ASSERT_TRUE(near);
  EXPECT_GT(near->mean(), mean_flip(board(0), board(1))) << "nearer, the squares are seen";
}

TEST(Flip, TransparentIsSeenOverGrey) {
  Picture clear = flat({255, 0, 0});
  for (std::size_t i = 3; i < clear.rgba.size(); i += 4) clear.rgba[i] = 0;
  // Mid-grey lies half a level from 128, which is 0.2 in lightness.
  EXPECT_NEAR(mean_flip(clear, flat({128, 128, 128})), flat_error({53.3890, 0, 0}, {53.5850, 0, 0}), 1e-3);
  EXPECT_GT(mean_flip(clear, flat({255, 0, 0})), 0.3);
}

TEST(Flip, SizesMustBeTheSame) {
  const auto map = flip(flat({0, 0, 0}), painted(30, 40, [](int, int) { return Rgb{0, 0, 0}; }));
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().kind, ErrorKind::bad_input);
  EXPECT_NE(map.error().message.find("40x30 and 30x40"), std::string::npos) << map.error().message;
}

TEST(Flip, SmallAndEmptyPicturesAreNoMistake) {
  const Picture one{1, 1, {0, 0, 0, 255}}, other{1, 1, {255, 255, 255, 255}};
  EXPECT_NEAR(mean_flip(one, other), 0.967, 1e-3);
  EXPECT_EQ(mean_flip(Picture{}, Picture{}), 0.0);
}

TEST(Flip, TakesAMomentForAFilmsFrame) {
  const auto frame = [](int shift) {
    return painted(1280, 720, [&](int x, int y) { return Rgb{(x + shift) % 256, y % 256, (x * y + shift) % 256}; });
  };
  const Picture a = frame(0), b = frame(3);
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_GT(mean_flip(a, b), 0.0);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
  // Half a second on two cores; ten times as long where they are shared or checked by sanitizers.
  EXPECT_LT(taken.count(), 5.0);
}

}  // namespace
}  // namespace sinew
