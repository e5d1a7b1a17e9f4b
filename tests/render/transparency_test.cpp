#include <algorithm>
#include <numeric>

#include "engine/render/layers.h"
#include "tests/render/stage_set.h"

namespace sinew::test {
namespace {

/// A sheet of glass: where it stands, its linear colour, its opacity.
struct Sheet {
  double z = 0.0;
  Vec3 colour{0.0};
  double alpha = 1.0;
};

const std::vector<Sheet> sheets{{-0.4, {1.0, 0.1, 0.1}, 0.5}, {-0.1, {0.1, 0.8, 0.2}, 0.4},
                                {0.2, {0.1, 0.2, 0.9}, 0.6},  {0.5, {0.7, 0.7, 0.1}, 0.3},
                                {0.7, {0.2, 0.6, 0.6}, 0.45}, {0.9, {0.9, 0.5, 0.2}, 0.35}};

Model glass(const std::vector<Sheet>& all) {
  Squares squares;
  for (const Sheet& sheet : all) {
    Material& material = squares.add({0, 0, sheet.z}, 0.6);
    material.base_colour = Vec4(sheet.colour, sheet.alpha);
    material.alpha_mode = AlphaMode::blend;
  }
  return squares.model;
}

/// The painter's result over white: farthest first, each over what is there, of eight bits after each.
Vec3 painted(std::vector<Sheet> all) {
  std::ranges::sort(all, {}, &Sheet::z);
  Vec3 colour(255.0);
  for (const Sheet& sheet : all)
    for (int i = 0; i < 3; ++i)
      colour[i] = std::round(srgb(sheet.colour[i]) * sheet.alpha + colour[i] * (1.0 - sheet.alpha));
  return colour;
}

class Transparency : public DeviceTest {};

TEST_F(Transparency, LayersBlendFromTheFarthestWhateverTheirOrder) {
  const Vec3 expected = painted(sheets);
  std::vector<std::size_t> order(sheets.size());
  std::iota(order.begin(), order.end(), 0);
  std::optional<Picture> first;
  // Six rotations and their reverses: every sheet is once before and once after every other.
  for (std::size_t turn = 0; turn < 2 * sheets.size(); ++turn) {
    std::vector<Sheet> all;
    for (const std::size_t i : order) all.push_back(sheets[i]);
    const Picture picture = drawn(glass(all));
    // Eight bits are rounded once a layer by the driver as here, to even or up: one level in all.
    expect_colour(middle(picture), expected, 2.0);
    if (!first) first = picture;
    EXPECT_EQ(picture.rgba, first->rgba) << "order " << turn;
    std::ranges::rotate(order, order.begin() + 1);
    if (turn + 1 == sheets.size()) std::ranges::reverse(order);
  }
}

TEST_F(Transparency, DrawingOrderIsNotEnough) {
  // What the test above would miss if the sheets commuted.
  std::vector<Sheet> swapped = sheets;
  std::swap(swapped.front().z, swapped.back().z);
  EXPECT_GT(glm::length(painted(sheets) - painted(swapped)), 30.0);
}

TEST_F(Transparency, SheetsThatCrossAreSortedPixelByPixel) {
  Squares squares;
  Material& red = squares.add({0, 0, 0}, 0.8);
  red.base_colour = {1, 0, 0, 0.5};
  red.alpha_mode = AlphaMode::blend;
  // On the left this end is nearer, on the right that one.
  for (Vec3& p : squares.last().positions) p.z = -0.5 * p.x;
  Material& blue = squares.add({0, 0, 0}, 0.8);
  blue.base_colour = {0, 0, 1, 0.5};
  blue.alpha_mode = AlphaMode::blend;
  for (Vec3& p : squares.last().positions) p.z = 0.5 * p.x;
  const Picture picture = drawn(squares.model);
  const Rgba left = at(picture, 20, 32), right = at(picture, 44, 32);
  EXPECT_GT(left[0], left[2] + 30);
  EXPECT_GT(right[2], right[0] + 30);
}

TEST_F(Transparency, NothingIsLostBehindTheLastLayer) {
  std::vector<Sheet> many;
  for (std::uint32_t i = 0; i < TransparentLayers::count + 3; ++i) many.push_back({0.1 * i, Vec3(0.2), 0.2});
  // All alike: any order gives the same.
  expect_colour(middle(drawn(glass(many))), painted(many), 3.0);
}

TEST_F(Transparency, OpaqueHidesWhatIsBehindAndShowsThroughWhatIsBefore) {
  Squares squares;
  Material& behind = squares.add({0, 0, -0.5}, 0.8);
  behind.base_colour = {1, 0, 0, 0.5};
  behind.alpha_mode = AlphaMode::blend;
  squares.add({0, 0, 0}, 0.8).base_colour = {0, 1, 0, 1};
  expect_colour(middle(drawn(squares.model)), {0, 255, 0});
  Material& before = squares.add({0, 0, 0.5}, 0.4);
  before.base_colour = {0, 0, 1, 0.5};
  before.alpha_mode = AlphaMode::blend;
  expect_colour(middle(drawn(squares.model)), {0, 127.5, 127.5});
}

TEST_F(Transparency, FourSamplesSortAlike) {
  const Picture one = drawn(glass(sheets)), four = drawn(glass(sheets), {.samples = 4});
  expect_colour(middle(four), painted(sheets), 2.0);
  EXPECT_EQ(middle(one), middle(four));
}

TEST_F(Transparency, WhatIsInvisibleTakesNoLayer) {
  std::vector<Sheet> all = sheets;
  for (int i = 0; i < 12; ++i) all.push_back({0.91 + 0.005 * i, Vec3(1.0), 0.0});
  expect_colour(middle(drawn(glass(all))), painted(sheets), 2.0);
}

TEST_F(Transparency, MasksCutWithoutBlending) {
  Squares squares;
  squares.add({0, 0, -0.2}, 0.8).base_colour = {0, 0, 1, 1};
  Material& mask = squares.add({0, 0, 0}, 0.8);
  mask.base_colour = {1, 0, 0, 1};
  mask.alpha_mode = AlphaMode::mask;
  mask.alpha_cutoff = 0.5;
  // The left half is let through, the right half is not.
  mask.base_colour_texture.image = squares.image({255, 255, 255, 100, 255, 255, 255, 200}, 2, 1);
  mask.base_colour_texture.nearest_filter = true;
  const Picture picture = drawn(squares.model);
  expect_colour(at(picture, 20, 32), {0, 0, 255});
  expect_colour(at(picture, 44, 32), {255, 0, 0});
}

}  // namespace
}  // namespace sinew::test
