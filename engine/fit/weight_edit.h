#pragma once
/// Tools that change skin weights that are there. engine/definitions.md 18.

#include <cstddef>
#include <optional>

#include "engine/core/result.h"
#include "engine/fit/mirrored_weights.h"
#include "engine/fit/skinned_shape.h"
#include "engine/model/model.h"

namespace sinew {

/// Weights moved `rounds` times half way to the mean of their neighbours; vertices at one place stay one.
Influences smoothed_weights(const SkinnedShape& shape, const Influences& influences, int rounds);

/// At most `most` influences a vertex, none below `least` but the largest.
Influences limited_weights(const Influences& influences, std::size_t most, double least);

struct WeightEdits {
  int smooth = 0;                  ///< rounds
  std::optional<BodySide> mirror;  ///< whose weights go to the other side
  double prune = 0.0;
  std::size_t influences = max_influences;
};

/// Smooths, mirrors, prunes and limits the weights of every skin of the model, in this order. Fails as
/// mirrored_weights() does.
Result<void> edit_weights(const WeightEdits& edits, Model& model);

}  // namespace sinew
