#pragma once
/// A skinned character whose weights are forgotten and found again from poses of its own.

#include <cstdint>

#include "engine/fit/shape_fit.h"
#include "engine/model/model.h"

namespace sinew {

struct RoundTripOptions : FitOptions {
  std::size_t poses = 20;      ///< examples at random angles
  std::size_t test_poses = 0;  ///< further ones, without noise, that the fit does not see
  std::uint64_t seed = 1;
  double noise = 0.0;  ///< sigma a coordinate of the examples, millimetres; a world unit is a metre
};

/// Replaces the weights of `rest`'s skinned meshes by those that fit `character` in random poses: every joint turned
/// within its limits, meshes skinned (ssd) by the character's own weights in their bind shape. The two must have the
/// same skinned meshes and skins; they may be the same model. Fails as bad_input naming what differs, or where nothing
/// is skinned; as interrupted.
Result<FitReport> fit_round_trip(const Model& character, const RoundTripOptions& options, Model& rest);

}  // namespace sinew
