#pragma once
/// Skin weights of a mesh from example poses. engine/definitions.md 16.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/fit/bone_poses.h"
#include "engine/model/model.h"

namespace sinew {

enum class FitMethod {
  convex,  ///< bones chosen as a set, weights none of which is negative, smoothed as far as noise asks
  paper,   ///< bones of the smallest lone errors, weights by SVD; negative ones are cut last
};

/// What a fit says of itself.
struct SkinFitReport {
  double noise = 0.0;  ///< standard deviation of the examples' noise a coordinate, as the fit sees it, world units
  std::size_t negative = 0;          ///< vertices of which the paper's method had a negative weight to cut
  std::size_t undetermined = 0;      ///< vertices whose weights the examples leave open
  std::vector<std::uint32_t> shell;  ///< [vertices] the connected piece a vertex belongs to
  std::size_t shells = 0;
};

/// Linear blend skinning solved for its weights: minimises `sum_k |sum_b w_b F_{b,k} v - v_k|^2` a vertex. The outcome
/// does not depend on the number of threads.
struct SkinFitJob {
  std::span<const Vec3> rest;                ///< [vertices] bind positions
  std::span<const Vec3> posed;               ///< [vertices * poses] a vertex's places in all poses, vertex after vertex
  std::span<const std::uint32_t> triangles;  ///< three vertex indices a triangle; who is whose neighbour
  const BonePoses& bones;
  FitMethod method = FitMethod::convex;
  std::size_t influences = 4;             ///< at most so many bones a vertex, 1 to max_influences
  std::function<void()> advance = [] {};  ///< called steps() times

  /// Says which span is short, which number is not finite, or that there are too few poses to tell weights from.
  Result<void> validate() const;
  std::size_t steps() const;
  /// The weights, [vertices], in the order that Influences asks for. Fails as interrupted between two blocks.
  Result<Influences> run(SkinFitReport& report) const;
};

/// Pairs of bones that no vertex tells apart: they moved alike in all poses, within 1e-9 of `size`. Each bone is named
/// with the first one before it.
std::vector<std::pair<std::uint32_t, std::uint32_t>> bones_moved_alike(const BonePoses& bones, const Bounds& rest);

}  // namespace sinew
