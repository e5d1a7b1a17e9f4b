#include "tests/render/stage_set.h"

namespace sinew::test {
namespace {

class Materials : public DeviceTest {};

/// One square that fills the picture, lit unless said.
struct OneSquare {
  OneSquare() : material(squares.add({0, 0, 0}, 1.5)) { material.unlit = false; }

  double brightness(const Setting& setting = {}) {
    const Rgba c = middle(drawn(squares.model, setting));
    return (c[0] + c[1] + c[2]) / 3.0;
  }

  Squares squares;
  Material& material;
};

/// A texture of one colour.
Texture flat_texture(OneSquare& one, const std::vector<unsigned char>& rgba) {
  Texture texture;
  texture.image = one.squares.image(rgba, 1, 1);
  return texture;
}

TEST_F(Materials, UnlitShowsItsColoursExactly) {
  OneSquare one;
  one.material.unlit = true;
  one.material.base_colour_texture = flat_texture(one, {37, 120, 241, 255});
  expect_colour(middle(drawn(one.squares.model)), {37, 120, 241});
  one.material.base_colour = {0.5, 0.25, 1.0, 1.0};
  const auto linear = [](double level) { return std::pow((level / 255.0 + 0.055) / 1.055, 2.4); };
  expect_colour(middle(drawn(one.squares.model)), {srgb(0.5 * linear(37)), srgb(0.25 * linear(120)), 241});
}

TEST_F(Materials, VertexColoursAreFactors) {
  OneSquare one;
  one.material.unlit = true;
  one.material.base_colour = {0.8, 0.8, 0.8, 1.0};
  one.squares.last().colours.assign(4, Vec4(0.5, 1.0, 0.25, 1.0));
  expect_colour(middle(drawn(one.squares.model)), {srgb(0.4), srgb(0.8), srgb(0.2)});
}

TEST_F(Materials, TexturesAreTurnedScaledAndMoved) {
  OneSquare one;
  one.material.unlit = true;
  // Black, red / green, blue.
  Texture& texture = one.material.base_colour_texture;
  texture.image = one.squares.image({0, 0, 0, 255, 255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255}, 2, 2);
  texture.nearest_filter = true;
  const auto corner = [&](int x, int y) { return at(drawn(one.squares.model), x, y); };
  expect_colour(corner(10, 10), {0, 0, 0});
  expect_colour(corner(54, 10), {255, 0, 0});
  texture.offset = {0.5, 0.0};
  expect_colour(corner(10, 10), {255, 0, 0});
  // A quarter turn counter-clockwise of the coordinates: the picture is seen turned the other way.
  texture.offset = {0.0, 1.0};
  texture.rotation = 0.5 * std::numbers::pi;
  for (const auto& [x, y] : {std::pair(10, 10), std::pair(54, 10), std::pair(10, 54), std::pair(54, 54)}) {
    const Vec2 uv((x + 0.5) / 64.0, (y + 0.5) / 64.0), looked_up = glm::fract(texture.apply(uv));
    const int texel = (looked_up.x > 0.5 ? 1 : 0) + (looked_up.y > 0.5 ? 2 : 0);
    const Vec3 colours[] = {{0, 0, 0}, {255, 0, 0}, {0, 255, 0}, {0, 0, 255}};
    expect_colour(corner(x, y), colours[texel]);
  }
}

TEST_F(Materials, TheSecondCoordinatesAreUsedWhereAskedFor) {
  OneSquare one;
  one.material.unlit = true;
  Texture& texture = one.material.base_colour_texture;
  texture.image = one.squares.image({255, 0, 0, 255, 0, 0, 255, 255}, 2, 1);
  texture.nearest_filter = true;
  texture.coordinates = 1;
  one.squares.last().second_texture_coordinates.assign(4, Vec2(0.75, 0.5));
  expect_colour(at(drawn(one.squares.model), 10, 32), {0, 0, 255});
}

TEST_F(Materials, NormalTexturesTiltTheNormal) {
  OneSquare one;
  one.material.base_colour = Vec4(0.5, 0.5, 0.5, 1);
  // 30 degrees to the right: (0.5, 0, 0.866).
  one.material.normal_texture = flat_texture(one, {191, 128, 238, 255});
  // Shown normals are (n + 1) / 2; eight bits hold the texel to 0.4 degrees, which is two levels.
  expect_colour(middle(drawn(one.squares.model, {.shading = Shading::normals})), {191, 127.5, 238}, 2.0);
  one.material.normal_scale = 0.0;
  expect_colour(middle(drawn(one.squares.model, {.shading = Shading::normals})), {127.5, 127.5, 255}, 1.0);
  // Green is up, though v points down.
  one.material.normal_scale = 1.0;
  one.material.normal_texture = flat_texture(one, {128, 191, 238, 255});
  expect_colour(middle(drawn(one.squares.model, {.shading = Shading::normals})), {127.5, 191, 238}, 2.0);
  // Mirrored coordinates turn red, and red alone, round.
  for (Vec2& uv : one.squares.last().texture_coordinates) uv.x = 1.0 - uv.x;
  one.material.normal_texture = flat_texture(one, {191, 191, 180, 255});
  const Rgba mirrored = middle(drawn(one.squares.model, {.shading = Shading::normals}));
  EXPECT_LT(mirrored[0], 100);
  EXPECT_GT(mirrored[1], 150);
}

TEST_F(Materials, MetalIsNotDiffuse) {
  OneSquare one;
  one.material.base_colour = {0.9, 0.2, 0.1, 1.0};
  one.material.roughness = 0.4;
  const Rgba plastic = middle(drawn(one.squares.model));
  one.material.metallic = 1.0;
  const Rgba metal = middle(drawn(one.squares.model));
  EXPECT_NE(plastic, metal);
  // A metal's mirror image takes its colour.
  EXPECT_GT(metal[0], 1.8 * metal[2]);
}

TEST_F(Materials, MetallicRoughnessTexturesAreFactors) {
  OneSquare textured, plain;
  textured.material.metallic = 0.8;
  textured.material.roughness = 0.9;
  // Blue is metal, green rough: 0.5 and 0.2 of them.
  textured.material.metallic_roughness_texture = flat_texture(textured, {0, 51, 128, 255});
  plain.material.metallic = 0.8 * 128 / 255;
  plain.material.roughness = 0.9 * 51 / 255;
  const Rgba expected = middle(drawn(plain.squares.model));
  expect_colour(middle(drawn(textured.squares.model)), {expected[0], expected[1], expected[2]});
}

TEST_F(Materials, OcclusionDarkensByItsStrength) {
  OneSquare one;
  one.material.base_colour = Vec4(0.5, 0.5, 0.5, 1);
  const double open = one.brightness();
  one.material.occlusion_texture = flat_texture(one, {0, 255, 255, 255});
  const double closed = one.brightness();
  one.material.occlusion_strength = 0.0;
  EXPECT_LT(closed, open - 3);
  EXPECT_NEAR(one.brightness(), open, 0.5);
}

TEST_F(Materials, EmissionIsAdded) {
  OneSquare one;
  one.material.base_colour = {0, 0, 0, 1};
  one.material.specular = 0.0;
  one.material.emissive = {0.2, 0.4, 0.6};
  one.material.emissive_texture = flat_texture(one, {255, 255, 0, 255});
  expect_colour(middle(drawn(one.squares.model)), {srgb(0.2), srgb(0.4), 0}, 2.0);
}

TEST_F(Materials, WeightsAreAHeatMap) {
  OneSquare one;
  const auto shown = [&](double weight) {
    return middle(drawn(one.squares.model, {.shading = Shading::weights, .weights = std::vector<double>(4, weight)}));
  };
  const Rgba none = shown(0.0), half = shown(0.5), all = shown(1.0);
  EXPECT_GT(none[2], none[0] + 20) << "blue";
  EXPECT_GT(half[1], half[0] + 20) << "green";
  EXPECT_GT(half[1], half[2] + 20) << "green";
  EXPECT_GT(all[0], all[2] + 60) << "red";
}

TEST_F(Materials, MipmapsKeepTheLightOfAFineGrid) {
  // Black and white texels, far finer than pixels: half the light, not half of the sRGB number.
  OneSquare one;
  one.material.unlit = true;
  std::vector<unsigned char> grid;
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x)
      for (int c = 0; c < 4; ++c) grid.push_back(c == 3 || (x + y) % 2 == 0 ? 255 : 0);
  one.material.base_colour_texture.image = one.squares.image(grid, 256, 256);
  one.material.base_colour_texture.scale = {8.0, 8.0};
  // The chain rounds to eight bits a level, and the sampler blends two of them.
  expect_colour(middle(drawn(one.squares.model)), Vec3(srgb(0.5)), 3.0);
}

}  // namespace
}  // namespace sinew::test
