#pragma once
/// A character's model, and what follows from it alone.

#include "engine/app/stage.h"
#include "engine/core/files.h"

namespace sinew {

/// Reads the model, gathers its mesh with the face that it may have, and finds its rest shape and humanoid bones.
/// `bytes`: of the model's file, where they were read already; a head that was drawn (StagedFace::head) needs none.
Result<void> stage_model(StagedCharacter& character, const SceneOptions& options, std::optional<Bytes> bytes);

}  // namespace sinew
