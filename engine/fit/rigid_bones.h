#pragma once
/// Bones and skin weights, both unknown, from example poses. Le and Deng, *Smooth Skinning Decomposition with Rigid
/// Bones*, 2012. engine/definitions.md 16.

#include <cstdint>
#include <functional>
#include <span>

#include "engine/core/result.h"
#include "engine/fit/bone_poses.h"
#include "engine/model/model.h"

namespace sinew {

struct RigidBones {
  BonePoses bones;         ///< rotation and translation, from the rest pose
  Influences influences;   ///< [vertices]
  std::size_t rounds = 0;  ///< of weights and transforms in turn
};

/// Minimises `sum_v sum_k |sum_b w_b F_{b,k} v - v_k|^2` over weights and rigid transforms in turn. Bones start as
/// clusters of vertices that move alike. The outcome does not depend on the number of threads.
struct RigidBonesJob {
  std::span<const Vec3> rest;                ///< [vertices]
  std::span<const Vec3> posed;               ///< [vertices * poses] vertex after vertex
  std::span<const std::uint32_t> triangles;  ///< three vertex indices a triangle
  std::size_t poses = 0;
  std::size_t count = 20;                 ///< bones
  std::size_t influences = 4;             ///< at most so many bones a vertex
  std::size_t rounds = 30;                ///< at most; fewer where a round gains less than 0.2 %
  std::function<void()> advance = [] {};  ///< called at most `rounds` + 1 times

  /// Fails as bad_input where a span is short, a number is not finite, or there are no two poses, counting the rest;
  /// where fewer than `count` motions are to be told apart; as interrupted.
  Result<RigidBones> run() const;
};

}  // namespace sinew
