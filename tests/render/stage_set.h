#pragma once
/// Flat things in front of a camera, for tests of what a renderer draws.

#include <array>

#include "engine/io/png.h"
#include "engine/render/renderer.h"
#include "tests/gpu/device_fixture.h"
#include "tests/support/test_character.h"

namespace sinew::test {

using Rgba = std::array<int, 4>;

/// A model of flat squares that face +Z, each with a material of its own; vertices are not skinned.
class Squares {
 public:
  Squares() {
    model.nodes.emplace_back().mesh = 0;
    model.roots = {0};
    model.meshes.emplace_back();
  }

  /// A square with this centre and half side. Its texture coordinates run from (0, 0) at the upper left to (1, 1).
  Material& add(const Vec3& centre, double half) {
    Primitive square;
    for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
      square.positions.push_back(centre + half * Vec3(corner, 0.0));
      square.normals.push_back({0, 0, 1});
      square.texture_coordinates.push_back({0.5 + 0.5 * corner.x, 0.5 - 0.5 * corner.y});
    }
    square.indices = {0, 1, 2, 0, 2, 3};
    square.material = static_cast<int>(model.materials.size());
    model.meshes[0].primitives.push_back(square);
    Material& material = model.materials.emplace_back();
    material.unlit = true;
    return material;
  }

  Primitive& last() { return model.meshes[0].primitives.back(); }

  /// A picture for textures: its number.
  int image(const std::vector<unsigned char>& rgba, int width, int height) {
    model.images.push_back({"", *encode_png(rgba, width, height)});
    return static_cast<int>(model.images.size()) - 1;
  }

  Model model;
};

struct Setting {
  Shading shading = Shading::lit;
  int samples = 1;
  WireMode wire = WireMode::none;
  bool shadows = false;
  std::optional<double> floor = {};
  std::vector<double> weights = {};
  Vec3 eye{0, 0, 5};
  Vec3 target{0, 0, 0};
  int side = 64;
};

/// The model from +Z on a white ground, 64 x 64; a square of half side 1.34 round the origin fills the picture.
inline Picture drawn(const Model& model, const Setting& setting = {}) {
  const TestCharacter character(model);
  auto renderer =
      Renderer::create(device(), {setting.side, setting.side, setting.samples, setting.wire});
  EXPECT_TRUE(renderer) << renderer.error().message;
  std::vector<std::string> problems;
  const auto added = renderer->add_character(character.model, character.mesh, character.rest, {}, {},
                                             {setting.weights}, problems);
  EXPECT_TRUE(added) << added.error().message;
  EXPECT_TRUE(problems.empty());
  const Pose pose = rest_pose(character.model);
  const auto palette = character.palette(pose);
  renderer->deformer(0).set_state({palette, {}, {}});
  Shot shot;
  shot.viewpoint.eye = setting.eye;
  shot.viewpoint.back = glm::normalize(setting.eye - setting.target);
  shot.viewpoint.right = glm::normalize(glm::cross(Vec3(0, 1, 0), shot.viewpoint.back));
  shot.viewpoint.up = glm::cross(shot.viewpoint.back, shot.viewpoint.right);
  shot.viewpoint.near_plane = 1.0;
  shot.viewpoint.far_plane = 20.0;
  shot.shading = setting.shading;
  shot.background = {1, 1, 1, 1};
  for (const Vec3& p : character.mesh.positions) shot.scene.add(p);
  shot.shadows = setting.shadows;
  shot.floor = setting.floor;
  auto picture = renderer->draw(shot);
  EXPECT_TRUE(picture) << picture.error().message;
  return std::move(*picture);
}

inline Rgba at(const Picture& picture, int x, int y) {
  const std::uint8_t* p = &picture.rgba[(std::size_t(y) * picture.width + x) * 4];
  return {p[0], p[1], p[2], p[3]};
}

inline Rgba middle(const Picture& picture) { return at(picture, picture.width / 2, picture.height / 2); }

/// sRGB levels of 255 of a linear number.
inline double srgb(double c) {
  return 255.0 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055);
}

/// Within one level a channel: rounding to eight bits, and single precision.
inline void expect_colour(const Rgba& found, const Vec3& srgb_levels, double tolerance = 1.0) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], srgb_levels[i], tolerance) << "channel " << i;
}

}  // namespace sinew::test
