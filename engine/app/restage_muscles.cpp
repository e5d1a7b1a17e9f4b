#include "engine/app/complete_stage.h"
#include "engine/app/stage_use.h"

namespace sinew {

Result<void> restage_muscles(Stage& stage, const Scene& scene, const SceneOptions& options) {
  std::vector<std::vector<PlacedMuscle>> placed(stage.characters.size());
  for (std::size_t c = 0; c < stage.characters.size(); ++c) {
    const StagedCharacter& character = stage.characters[c];
    const std::vector<MuscleSpec>&before = character.scene.muscles, &wanted = scene.characters[c].muscles;
    for (std::size_t m = 0; m < wanted.size(); ++m) {
      if (wanted[m] == before[m]) {
        placed[c].push_back(character.muscles[m]);
        continue;
      }
      auto muscle = place_muscle(placement_context(character), wanted[m]);
      if (!muscle) return ScenePlace(stage.source, false, c).at(fmt::format("/muscles/{}", m), std::move(muscle));
      placed[c].push_back(std::move(*muscle));
    }
  }
  for (std::size_t c = 0; c < stage.characters.size(); ++c) {
    StagedCharacter& character = stage.characters[c];
    for (const PlacedMuscle& old : character.muscles)
      for (const std::string& problem : placement_problems(old))
        std::erase(stage.problems, named_problem(character, problem));
    character.muscles = std::move(placed[c]);
    character.scene.muscles = scene.characters[c].muscles;
    for (const PlacedMuscle& muscle : character.muscles)
      for (const std::string& problem : placement_problems(muscle))
        stage.problems.push_back(named_problem(character, problem));
  }
  stage.scene = scene;
  stage.scene_hash = hash_scene(stage, options);
  return {};
}

}  // namespace sinew
