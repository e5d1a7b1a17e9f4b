#include <random>

#include "engine/render/frustum.h"
#include "engine/render/studio.h"
#include "tests/render/stage_set.h"

namespace sinew::test {
namespace {

class Shadows : public DeviceTest {};

int level(const Rgba& c) { return c[0] + c[1] + c[2]; }

/// A wall, and a small square hung up between it and the light.
Model wall_and_square(double distance) {
  Squares squares;
  squares.add({0, 0, 0}, 1.3).unlit = false;
  squares.add({-0.3, 0.3, distance}, 0.25).unlit = false;
  return squares.model;
}

TEST_F(Shadows, FallAwayFromTheKeyLight) {
  const Model model = wall_and_square(0.5);
  const Picture with = drawn(model, {.shadows = true}), without = drawn(model);
  // The key light comes from the upper left: (-0.52, 0.62, 0.59) carries the shadow by (0.44, -0.53) for 0.5.
  const auto pixel = [](double x) { return static_cast<int>(32 + 32 * x / 1.34); };
  EXPECT_LT(level(at(with, pixel(0.14), pixel(0.23))), level(at(without, pixel(0.14), pixel(0.23))) - 60);
  // Not on the other side, nor on the square itself.
  EXPECT_EQ(at(with, pixel(-0.9), pixel(0.9)), at(without, pixel(-0.9), pixel(0.9)));
  EXPECT_NEAR(level(at(with, pixel(-0.33), pixel(-0.33))), level(at(without, pixel(-0.33), pixel(-0.33))), 3);
}

TEST_F(Shadows, NoSurfaceShadesItself) {
  Squares squares;
  squares.add({0, 0, 0}, 1.3).unlit = false;
  const Picture with = drawn(squares.model, {.shadows = true}), without = drawn(squares.model);
  EXPECT_EQ(with.rgba, without.rgba);
}

TEST_F(Shadows, HolesInAMaskLetLightThrough) {
  Model model = wall_and_square(0.5);
  model.materials[1].alpha_mode = AlphaMode::mask;
  model.materials[1].base_colour.a = 0.2;
  const Picture cut = drawn(model, {.shadows = true});
  Squares wall;
  wall.add({0, 0, 0}, 1.3).unlit = false;
  EXPECT_EQ(at(cut, 35, 37), at(drawn(wall.model), 35, 37));
}

TEST_F(Shadows, WhatBlendsThrowsOneWhereItIsMoreThereThanNot) {
  Model opaque = wall_and_square(0.5), blended = opaque, faint = opaque;
  blended.materials[1].alpha_mode = faint.materials[1].alpha_mode = AlphaMode::blend;
  faint.materials[1].base_colour.a = 0.2;
  Squares wall;
  wall.add({0, 0, 0}, 1.3).unlit = false;
  const Picture solid = drawn(opaque, {.shadows = true}), bare = drawn(wall.model);
  ASSERT_NE(at(solid, 35, 37), at(bare, 35, 37));
  EXPECT_EQ(at(drawn(blended, {.shadows = true}), 35, 37), at(solid, 35, 37));
  const Picture thin = drawn(faint, {.shadows = true}), thin_unshaded = drawn(faint);
  EXPECT_EQ(at(thin, 35, 37), at(thin_unshaded, 35, 37));
}

TEST_F(Shadows, TheFloorShowsThemAndNothingElse) {
  Squares squares;
  // Seen from above a sheet that stands upright hides much of its shadow: this one lies.
  squares.add({0, 0.5, 0}, 0.5);
  for (Vec3& p : squares.last().positions) p = {p.x, 0.3, 0.5 - p.y};
  squares.last().normals.assign(4, Vec3(0, 1, 0));
  const Setting above{.shadows = true, .floor = 0.0, .eye = {0, 3, 4}, .target = {0, 0.3, 0}};
  Setting none = above;
  none.floor.reset();
  const Picture with = drawn(squares.model, above), without = drawn(squares.model, none);
  int darker = 0, brighter = 0;
  for (std::size_t i = 0; i < with.rgba.size(); ++i) {
    darker += with.rgba[i] < without.rgba[i] ? 1 : 0;
    brighter += with.rgba[i] > without.rgba[i] ? 1 : 0;
  }
  EXPECT_GT(darker, 300);
  EXPECT_EQ(brighter, 0);
  Setting contact = above;
  contact.shadows = false;
  const Picture uncast = drawn(squares.model, contact);
  int cast = 0;
  for (std::size_t i = 0; i < with.rgba.size(); ++i) cast += with.rgba[i] < uncast.rgba[i] ? 1 : 0;
  EXPECT_GT(cast, 100) << "the key light's shadow is not there";
  // The far corners of the picture lie beyond all shadows.
  EXPECT_EQ(at(with, 1, 1), at(without, 1, 1));
  Setting below = above;
  below.eye = {0, -3, 4};
  below.target = {0, 0, 0};
  Setting bare = below;
  bare.floor.reset();
  EXPECT_EQ(drawn(squares.model, below).rgba, drawn(squares.model, bare).rgba) << "seen from below";
}

TEST_F(Shadows, PlainModesHaveNone) {
  const Model model = wall_and_square(0.5);
  for (const Shading shading : {Shading::clay, Shading::normals, Shading::depth})
    EXPECT_EQ(drawn(model, {.shading = shading, .shadows = true, .floor = -1.0}).rgba,
              drawn(model, {.shading = shading}).rgba);
}

TEST(Studio, LightsStandRelativeToTheCamera) {
  Viewpoint turned;
  turned.right = {0, 0, -1};
  turned.back = {1, 0, 0};
  Bounds box;
  box.add(Vec3(-1, 0, -1));
  box.add(Vec3(1, 2, 1));
  const Studio front = make_studio({}, 1.5, box, 0.0), side = make_studio(turned, 1.5, box, 0.0);
  const glm::dmat3 axes(turned.right, turned.up, turned.back);
  EXPECT_LT(glm::length(side.key - axes * front.key), 1e-12);
  for (const Vec3& direction : {front.key, front.fill, front.rim}) EXPECT_NEAR(glm::length(direction), 1.0, 1e-12);
}

TEST(Studio, MapsHoldTheWholeSceneAndTheFloorItsShadow) {
  Bounds box;
  box.add(Vec3(-0.7, 0.1, -0.4));
  box.add(Vec3(0.9, 1.8, 0.5));
  const Viewpoint camera = frame_box(box, {}, 1.5);
  const Studio studio = make_studio(camera, 1.5, box, 0.1);
  for (int i = 0; i < 8; ++i) {
    const Vec4 clip = studio.light_projection * Vec4(box.corner(i), 1.0);
    EXPECT_LE(std::max(std::abs(clip.x), std::abs(clip.y)), 1.0);
    EXPECT_GE(clip.z, 0.0);
    EXPECT_LE(clip.z, 1.0);
    // Along the light down to the floor.
    const Vec3 corner = box.corner(i), fallen = corner - studio.key * ((corner.y - 0.1) / studio.key.y);
    EXPECT_LE(std::abs(fallen.x - studio.floor_centre.x), studio.floor_half_size.x + 1e-9);
    EXPECT_LE(std::abs(fallen.z - studio.floor_centre.z), studio.floor_half_size.y + 1e-9);
    // The far plane does not cut it off.
    EXPECT_LT(glm::dot(camera.eye - fallen, camera.back), studio.viewpoint.far_plane);
  }
}

TEST(Studio, WhatIsSeenFromNearByHasAFinerMapWithAllThatShadesIt) {
  Bounds box;
  box.add(Vec3(-0.9, 0.0, -0.3));
  box.add(Vec3(0.9, 1.8, 0.3));
  const Viewpoint whole = frame_box(box, {}, 1.0), near = look_at({0.05, 1.6, 0.1}, 0.6, box, {});
  const Studio far_off = make_studio(whole, 1.0, box, 0.0), close = make_studio(near, 1.0, box, 0.0);
  EXPECT_LT(close.shadow_width, 0.5 * far_off.shadow_width);
  const Frustum frustum = frustum_of(near, 1.0);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> x(-0.9, 0.9), y(0.0, 1.8), z(-0.3, 0.3);
  int seen = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p(x(generator), y(generator), z(generator));
    bool within = true;
    for (const Vec4& plane : frustum.planes) within = within && glm::dot(plane, Vec4(p, 1.0)) >= 0.0;
    if (!within) continue;
    ++seen;
    const Vec4 clip = close.light_projection * Vec4(p, 1.0);
    EXPECT_LE(std::max(std::abs(clip.x), std::abs(clip.y)), 1.0);
    // What is on the way to the light lies at the same place of the map, and before it.
    const Vec4 shading = close.light_projection * Vec4(p + 0.1 * close.key, 1.0);
    EXPECT_NEAR(shading.x, clip.x, 1e-12);
    EXPECT_NEAR(shading.y, clip.y, 1e-12);
    EXPECT_LT(shading.z, clip.z);
  }
  EXPECT_GT(seen, 300);
  for (int i = 0; i < 8; ++i) {
    const double depth = (close.light_projection * Vec4(box.corner(i), 1.0)).z;
    EXPECT_GE(depth, 0.0);
    EXPECT_LE(depth, 1.0);
  }
}

}  // namespace
}  // namespace sinew::test
