#pragma once
/// A smooth surface as loose stencils: each sample is a vertex with four neighbours a hair away, so that the tangents,
/// and with them the normal, of whatever becomes of the surface can be had by central differences.

#include <functional>
#include <numbers>
#include <vector>

#include "tests/support/test_character.h"
#include "tests/support/tube.h"

namespace sinew::test {

constexpr double stencil_reach = 1e-5;

/// Two parameters to a place in the bind pose.
using Surface = std::function<Vec3(double u, double v)>;

struct PatchShape {
  Surface surface;
  Vec2 low{-0.3, 0.0}, high{0.3, 1.0};                 ///< of the parameters
  std::vector<Influence> weights{{0, 0.7}, {1, 0.3}};  ///< the same everywhere: the patch is carried as one
  Transform bone_rest{};                               ///< rest transform of the bone; its bind pose is the identity
  std::size_t samples = 300;
};

/// Nodes of patch(): the joints of a limb along +Y, each a unit beyond the one before.
enum PatchNode { patch_bone, patch_child, patch_tip, patch_skin };

/// The surface's normal by central differences with a step that hardly matters: u cross v is outwards.
inline Vec3 surface_normal(const Surface& surface, double u, double v) {
  constexpr double h = 1e-6;
  return glm::normalize(glm::cross(surface(u + h, v) - surface(u - h, v), surface(u, v + h) - surface(u, v - h)));
}

/// Sample i is the vertices 5i to 5i + 4: the middle, -u, +u, -v, +v.
inline Model patch(const PatchShape& shape) {
  Model model;
  add_node(model, "bone", -1, shape.bone_rest);
  add_node(model, "child", patch_bone, {.translation = {0, 1, 0}});
  add_node(model, "tip", patch_child, {.translation = {0, 1, 0}});
  add_node(model, "skin", -1, {});
  model.nodes[patch_skin].mesh = model.nodes[patch_skin].skin = 0;
  model.skins.push_back({"skin", {patch_bone, patch_child}, {Mat4(1.0), glm::translate(Mat4(1.0), {0, -1, 0})}});
  Primitive skin;
  Random random(11);
  for (std::size_t i = 0; i < shape.samples; ++i) {
    const double u = random.between(shape.low.x, shape.high.x), v = random.between(shape.low.y, shape.high.y);
    for (const Vec2& step : {Vec2(0, 0), Vec2(-1, 0), Vec2(1, 0), Vec2(0, -1), Vec2(0, 1)}) {
      const double pu = u + stencil_reach * step.x, pv = v + stencil_reach * step.y;
      skin.positions.push_back(shape.surface(pu, pv));
      skin.normals.push_back(surface_normal(shape.surface, pu, pv));
      skin.influences.add_vertex(shape.weights);
    }
  }
  skin.indices = {0, 2, 4};
  model.meshes.push_back({"patch", {skin}, {}});
  return model;
}

/// The normal of the surface that the vertices of sample i lie on now.
inline Vec3 stencil_normal(const std::vector<Vec3>& positions, std::size_t i) {
  const Vec3* p = &positions[5 * i];
  return glm::normalize(glm::cross(p[2] - p[1], p[4] - p[3]));
}

/// Slopes of a quantity over sample i along u and v.
inline Vec2 stencil_slope(const std::vector<double>& values, std::size_t i) {
  const double* h = &values[5 * i];
  return Vec2(h[2] - h[1], h[4] - h[3]) / (2.0 * stencil_reach);
}

inline Vec3 flat(double u, double v) { return {u, v, 0.25}; }
inline Vec3 round_limb(double u, double v) { return {0.25 * std::sin(u / 0.25), v, 0.25 * std::cos(u / 0.25)}; }

/// Across a patch along +Y, facing +Z, driven by the tip.
inline Muscle patch_muscle() {
  Muscle muscle;
  muscle.name = "belly";
  muscle.bone = patch_bone;
  muscle.child = muscle.driver = patch_child;
  muscle.tip = patch_tip;
  muscle.facing = {0, 0, 1};
  muscle.from = 0.1;
  muscle.to = 0.9;
  muscle.spread = 80;
  muscle.peak = 0.06;
  muscle.sigma = {0.2, 0.15};
  return muscle;
}

}  // namespace sinew::test
