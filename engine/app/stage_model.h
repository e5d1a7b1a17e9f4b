#pragma once
/// A character's model, and what follows from it alone.

#include "engine/app/scene_place.h"
#include "engine/app/stage.h"
#include "engine/core/files.h"

namespace sinew {

/// Reads the model or draws it from the scene's head, gathers its mesh with the face that it may have, and finds its
/// rest shape and humanoid bones. `scene`: whose character it is; `bytes`: of the model's file, where they were read
/// already. Counts `model_steps` items of the watch. Fails as bad_input; as interrupted.
Result<void> stage_model(StagedCharacter& character, const Scene& scene, const SceneOptions& options,
                         const ScenePlace& place, TaskWatch& watch, std::optional<Bytes> bytes = std::nullopt);

constexpr std::size_t model_steps = 2;

}  // namespace sinew
