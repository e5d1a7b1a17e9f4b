#pragma once
/// What follows from a stage's characters once all are there.

#include "engine/app/stage.h"

namespace sinew {

/// Adds the poses of the command line, finds the range and what of the faces is held at limits, and names what is
/// shown by its hash. Fails as bad_input where a pose is of a joint that no character has.
Result<void> complete_stage(Stage& stage, const SceneOptions& options);

/// Stage::scene_hash of a stage whose characters are all there.
std::string hash_scene(const Stage& stage, const SceneOptions& options);

}  // namespace sinew
