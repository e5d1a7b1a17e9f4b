#pragma once
/// A mesh hung on a skeleton that may come from another file.

#include <cstddef>

#include "engine/core/result.h"
#include "engine/model/model.h"

namespace sinew {

struct BindOptions {
  bool morphs = true;      ///< keep morph targets, as they act in the rest pose
  bool keep_hung = false;  ///< where both are one file: a mesh without a skin on or below a joint stays as it is
};

/// The meshes that `mesh` draws, standing still where they stand at rest, under one skin of all joints of `skeleton`
/// (those that its skins name; without skins every node that carries no mesh), bound in the skeleton's rest pose. Nodes
/// and clips are the skeleton's, under their indices; every drawn mesh gets a node of its own behind them, in the order
/// in which `export` writes vertices. Every vertex follows the first joint alone until weights are known.
/// Fails as bad_input where there is no joint, no vertex, or a joint whose rest transform cannot be undone.
Result<Model> bound_model(const Model& mesh, const Model& skeleton, const BindOptions& options = {});

}  // namespace sinew
