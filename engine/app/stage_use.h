#pragma once
/// What a scene makes of a character's model.

#include "engine/app/scene_place.h"
#include "engine/app/stage.h"

namespace sinew {

/// Finds the clip, the motions, the joints' tracks, the face and the muscles of a character whose model is there
/// already. `bare_model`: it is shown as its file has it, its muscles those that every character has by default.
/// `options`: with the scene's own library. What people should know goes to `problems`. Fails as bad_input.
Result<void> stage_use(StagedCharacter& character, const SceneOptions& options, bool bare_model, double fps,
                       const ScenePlace& place, std::vector<std::string>& problems);

}  // namespace sinew
