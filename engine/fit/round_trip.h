#pragma once
/// A skinned character whose weights are forgotten and found again from poses of its own.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/fit/skin_fit.h"
#include "engine/model/model.h"

namespace sinew {

struct RoundTripOptions {
  std::size_t poses = 20;      ///< examples at random angles
  std::size_t test_poses = 0;  ///< further ones, without noise, that the fit does not see
  std::uint64_t seed = 1;
  double noise = 0.0;  ///< sigma a coordinate of the examples, millimetres; a world unit is a metre
  std::size_t influences = 4;
  FitMethod method = FitMethod::convex;
  ProgressStyle progress = ProgressStyle::none;
};

struct WorstVertex {
  std::size_t vertex = 0;  ///< counted over all skinned meshes in the scene's order
  std::string mesh;
  double rmse = 0.0;  ///< over the poses
};

struct ShellResidual {
  std::string mesh;  ///< of its first vertex
  std::size_t vertices = 0;
  double rmse = 0.0;
};

/// Lengths in world units; errors are 3-D distances of the fitted weights to the examples.
struct RoundTripReport {
  std::size_t vertices = 0, poses = 0, bones = 0, max_influences = 0;
  double rmse = 0.0, max_error = 0.0, diagonal = 0.0, height = 0.0;
  double test_rmse = 0.0;     ///< in the test poses; 0 where there are none
  double noise = 0.0;         ///< sigma as the fit sees it, the largest of all skins'
  double milliseconds = 0.0;  ///< of the fit alone
  std::size_t negative = 0, undetermined = 0;
  std::vector<WorstVertex> worst;     ///< at most ten, the worst first
  std::vector<ShellResidual> shells;  ///< the worst first
  std::vector<std::string> reasons;   ///< what keeps weights open, for people
};

/// Replaces the weights of `rest`'s skinned meshes by those that fit `character` in random poses: every joint turned
/// within its limits, meshes skinned (ssd) by the character's own weights in their bind shape. The two must have the
/// same skinned meshes and skins; they may be the same model. Fails as bad_input naming what differs, or where nothing
/// is skinned; as interrupted.
Result<RoundTripReport> fit_round_trip(const Model& character, const RoundTripOptions& options, Model& rest);

}  // namespace sinew
