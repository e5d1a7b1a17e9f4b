#include "engine/app/stage.h"
#include "engine/app/stage_use.h"
#include "engine/body/muscle_spec.h"

namespace sinew {

Result<Scene> spelled_out_scene(const Stage& stage) {
  Scene scene = stage.scene;
  if (stage.is_scene) return scene;
  for (std::size_t i = 0; i < scene.characters.size(); ++i) {
    const StagedCharacter& character = stage.characters[i];
    const PlacementContext context = placement_context(character);
    Character& shown = scene.characters[i];
    if (character.clip >= 0) {
      const std::string& name = character.model->clips[static_cast<std::size_t>(character.clip)].name;
      const bool tells = !name.empty() && name != "none";
      shown.clip = tells ? ClipChoice(name) : ClipChoice(character.clip);
    }
    shown.muscles.clear();
    for (const PlacedMuscle& placed : character.muscles) {
      auto spec = explicit_muscle(context, placed);
      if (!spec) return pass_on(std::move(spec));
      shown.muscles.push_back(std::move(*spec));
    }
  }
  return scene;
}

}  // namespace sinew
