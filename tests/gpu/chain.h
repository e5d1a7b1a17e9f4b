#pragma once
/// A tube on a chain of joints with as many influences a vertex as a test asks for, a muscle on its middle, and poses.

#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "engine/body/muscle_placement.h"
#include "engine/deform/reference.h"
#include "engine/deform/skin_output.h"
#include "tests/support/tube.h"

namespace sinew::test {

enum class ChainPose { rest, bent, twisted, stretched };

/// Everything that both deformers take.
struct Chain {
  Model model;
  std::vector<int> order;
  CharacterMesh mesh;
  RestShape rest;
  std::vector<PlacedMuscle> muscles;
};

constexpr int chain_joints = 10;

/// On the middle of the tube's front.
inline MuscleSpec chain_muscle_spec() {
  MuscleSpec spec;
  spec.name = "belly";
  spec.bone = "joint3";
  spec.child = "joint7";
  spec.driver = "joint7";
  spec.tip = "joint8";
  spec.facing = Vec3(0, 0, 1);
  spec.from = 0.0;
  spec.to = 1.0;
  spec.spread = 80.0;
  spec.peak = 0.06;
  spec.sigma = Vec2(0.15, 0.12);
  spec.rest_angle = 180.0;
  spec.reference_angle = 60.0;
  return spec;
}

inline PlacedMuscle chain_muscle(const Chain& chain, const MuscleSpec& spec) {
  const Humanoid nobody;
  auto placed = place_muscle({chain.model, chain.mesh, chain.rest, nobody}, spec);
  EXPECT_TRUE(placed) << (placed ? "" : placed.error().message);
  return placed ? std::move(*placed) : PlacedMuscle{};
}

/// Joints stand at y = 0, 0.2, ... 1.8. Each vertex follows the `influences` nearest joints, weights random but smooth
/// in nothing: the worst case for a packing. Two morph targets move every third vertex. Tangents lie askew on the skin.
inline Chain make_chain(std::size_t influences, bool morphs = true, bool tangents = true) {
  Chain chain;
  Model& model = chain.model;
  model = tube({.rows = 41, .columns = 20});
  model.nodes.clear();
  model.roots.clear();
  Skin& skin = model.skins.front();
  skin = {};
  for (int j = 0; j < chain_joints; ++j) {
    add_node(model, "joint" + std::to_string(j), j - 1, {.translation = {0, j == 0 ? 0.0 : 0.2, 0}});
    skin.joints.push_back(j);
    skin.inverse_bind.push_back(glm::translate(Mat4(1.0), {0, -0.2 * j, 0}));
  }
  const int drawn = add_node(model, "skin", -1, {});
  model.nodes[drawn].mesh = model.nodes[drawn].skin = 0;

  Primitive& primitive = model.meshes.front().primitives.front();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.05, 1.0);
  primitive.influences = {};
  for (const Vec3& p : primitive.positions) {
    const int first = std::clamp(static_cast<int>(p.y / 0.2) - static_cast<int>(influences) / 2, 0,
                                 chain_joints - static_cast<int>(influences));
    std::vector<Influence> run;
    double total = 0.0;
    for (std::size_t i = 0; i < influences; ++i) {
      run.push_back({static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(i), unit(random)});
      total += run.back().weight;
    }
    for (Influence& influence : run) influence.weight /= total;
    primitive.influences.add_vertex(sorted_run(run));
  }
  if (morphs) {
    for (int t = 0; t < 2; ++t) {
      MorphTarget& target = primitive.morph_targets.emplace_back();
      for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
        target.positions.push_back(v % 3 == 0 ? 0.05 * Vec3(unit(random), unit(random), unit(random)) : Vec3(0.0));
        target.normals.push_back(v % 3 == 0 ? 0.2 * Vec3(unit(random), unit(random), unit(random)) : Vec3(0.0));
      }
    }
  }
  chain.order = hierarchy_order(model);
  chain.mesh = character_mesh(model);
  std::mt19937 askew(8);  // whether there are morphs or not, the same
  for (std::size_t v = 0; tangents && v < chain.mesh.vertices(); ++v)
    chain.mesh.tangents.push_back(
        tangent_in_plane(Vec4(unit(askew), unit(askew), -unit(askew), v % 2 == 0 ? 1 : -1), chain.mesh.normals[v]));
  chain.rest = rest_shape(model, chain.mesh, chain.order);

  chain.muscles.push_back(chain_muscle(chain, chain_muscle_spec()));
  return chain;
}

/// One pose of a chain: palette, morph weights, activations.
struct ChainState {
  std::vector<Mat34> palette;
  std::vector<double> morph_weights;
  std::vector<double> activations;
};

inline ChainState chain_state(const Chain& chain, ChainPose kind) {
  Pose pose = rest_pose(chain.model);
  for (int j = 1; j < chain_joints; ++j) {
    Transform& local = pose.local[j];
    if (kind == ChainPose::bent) local.rotation = rotation_xyz_degrees({j == 7 ? 90.0 : 6.0, 3.0 * j, -4.0});
    if (kind == ChainPose::twisted && j == 5) local.rotation = rotation_xyz_degrees({0, 179, 0});
    if (kind == ChainPose::stretched) {
      local.rotation = rotation_xyz_degrees({12, 5, 8});
      local.scale = {1.1, 0.9, 1.05};
    }
  }
  if (kind != ChainPose::rest)
    for (std::vector<double>& weights : pose.morph_weights)
      for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = 0.7 - 0.3 * static_cast<double>(i);
  ChainState state;
  const std::vector<Mat4> global = global_transforms(chain.model, chain.order, pose);
  state.palette = palette_transforms(chain.mesh, global);
  state.morph_weights = morph_slot_weights(chain.mesh, pose);
  for (const PlacedMuscle& placed : chain.muscles)
    state.activations.push_back(
        muscle_activation(placed.driver.degrees(global), placed.muscle.rest_angle, placed.muscle.reference_angle));
  return state;
}

inline DeformedVertices reference(const Chain& chain, const ChainState& state, Deformer deformer, BulgeMode bulge) {
  std::vector<ActiveMuscle> active;
  for (std::size_t i = 0; i < chain.muscles.size(); ++i)
    active.push_back({chain.muscles[i].muscle, chain.muscles[i].region, state.activations[i]});
  return deform_reference(chain.mesh, chain.rest, {state.palette, state.morph_weights, active, deformer, bulge});
}

}  // namespace sinew::test
