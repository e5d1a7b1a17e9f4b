#pragma once
/// What a scene makes of a character's model.

#include "engine/app/character_motions.h"

namespace sinew {

/// Finds the clip, the motions, the joints' tracks, the face and the muscles of a character whose model is there
/// already. `bare_model`: it is shown as its file has it, its muscles those that every character has by default.
/// `options`: with the scene's own library. What people should know goes to `problems`. Counts `use_steps` items of the
/// watch. Fails as bad_input; as interrupted.
Result<void> stage_use(StagedCharacter& character, const SceneOptions& options, bool bare_model, double fps,
                       const ScenePlace& place, const KnownMotions& known, std::vector<std::string>& problems,
                       TaskWatch& watch);

constexpr std::size_t use_steps = 2;

/// What muscles are placed on.
PlacementContext placement_context(const StagedCharacter& character);

/// As it stands among the stage's problems.
std::string named_problem(const StagedCharacter& character, const std::string& problem);

}  // namespace sinew
