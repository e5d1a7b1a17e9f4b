#pragma once
/// A model with everything that deforming it asks for.

#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "engine/deform/muscle_region.h"
#include "engine/deform/reference.h"
#include "engine/deform/rest_shape.h"
#include "engine/model/character_mesh.h"
#include "engine/rig/pose.h"

namespace sinew::test {

struct TestCharacter {
  explicit TestCharacter(Model m)
      : model(std::move(m)),
        mesh(character_mesh(model)),
        order(hierarchy_order(model)),
        rest(rest_shape(model, mesh, order)),
        rest_turns(rest_rotations(model, order)) {}

  /// The rest pose with one joint turned, degrees about the model's axes.
  Pose turned(int node, const Vec3& degrees) const {
    Pose pose = rest_pose(model);
    turn_joint(model, rest_turns, node, degrees, pose);
    return pose;
  }
  std::vector<Mat34> palette(const Pose& pose, const Mat4& placement = Mat4(1.0)) const {
    return palette_transforms(mesh, global_transforms(model, order, pose), placement);
  }
  MuscleRegion region(const Muscle& muscle) const {
    auto found = muscle_region(model, mesh, rest, muscle);
    if (found) return *found;
    ADD_FAILURE() << found.error().message;
    return {};
  }

  Model model;
  CharacterMesh mesh;
  std::vector<int> order;
  RestShape rest;
  std::vector<Quat> rest_turns;
};

/// How a character is asked to be deformed, beside its pose.
struct Deforming {
  std::span<const ActiveMuscle> muscles = {};
  BulgeMode bulge = BulgeMode::on;
  Deformer deformer = Deformer::ssd;
  Mat4 placement{1.0};
};

inline DeformedVertices deformed(const TestCharacter& character, const Pose& pose, const Deforming& how = {}) {
  const std::vector<Mat34> palette = character.palette(pose, how.placement);
  const std::vector<double> weights = morph_slot_weights(character.mesh, pose);
  return deform_reference(character.mesh, character.rest, {palette, weights, how.muscles, how.deformer, how.bulge});
}

inline double largest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  EXPECT_EQ(a.size(), b.size());
  if (a.size() != b.size()) return INFINITY;
  double largest = 0.0;
  // Written so that a number that is none counts as far.
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(glm::length(a[i] - b[i]) <= largest))
      largest = std::isnan(a[i].x + b[i].x) ? INFINITY : glm::length(a[i] - b[i]);
  return largest;
}

/// Numbers that are the same in every run.
class Random {
 public:
  explicit Random(unsigned seed = 1) : engine_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Vec3 vector(double reach = 1.0) { return {between(-reach, reach), between(-reach, reach), between(-reach, reach)}; }
  Quat rotation() { return rotation_xyz_degrees(vector(180.0)); }
  Mat4 rigid_motion() {
    Transform t{vector(), rotation()};
    return t.matrix();
  }
  std::size_t index(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_); }

 private:
  std::mt19937 engine_;
};

}  // namespace sinew::test
