#include "engine/app/stage_parts.h"

#include "engine/app/stage_model.h"

namespace sinew {

bool has_model_of(const StagedCharacter& known, const Character& character) {
  return known.model && known.scene.model == character.model && known.scene.head == character.head &&
         known.scene.landmarks == character.landmarks;
}

KnownMotions known_motions(const Stage& stage) {
  KnownMotions known;
  for (const StagedCharacter& character : stage.characters) {
    if (character.motion) known.push_back(*character.motion);
    known.insert(known.end(), character.emotions.begin(), character.emotions.end());
  }
  known.insert(known.end(), stage.spare_motions.begin(), stage.spare_motions.end());
  return known;
}

MissingParts missing_parts(const Stage& stage, const Scene& scene, const SceneOptions& options) {
  MissingParts missing{{}, scene, options_of(scene, options), stage.source, known_motions(stage)};
  std::vector<const StagedCharacter*> models;
  for (const std::vector<StagedCharacter>* list : {&stage.characters, &stage.spare})
    for (const StagedCharacter& character : *list) models.push_back(&character);
  for (std::size_t i = 0; i < scene.characters.size(); ++i) {
    const Character& character = scene.characters[i];
    const auto known = std::ranges::find_if(
        models, [&](const StagedCharacter* candidate) { return candidate && has_model_of(*candidate, character); });
    MissingParts::Part part{i, known == models.end(), {}};
    bool lacks = part.needs_model;
    if (!part.needs_model) {
      part.known.model = (*known)->model;
      part.known.model_hash = (*known)->model_hash;
      part.known.humanoid = (*known)->humanoid;
      *known = nullptr;
      const auto origins = motion_origins(character, missing.options, scene.fps, part.known.model_hash);
      lacks = std::ranges::any_of(
          origins, [&](const MotionOrigin& origin) { return find_motion(missing.motions, origin) == nullptr; });
    }
    if (lacks) missing.parts.push_back(std::move(part));
  }
  return missing;
}

Result<StageParts> make_parts(const MissingParts& missing, TaskWatch& watch) {
  StageParts made;
  watch.begin(missing.parts.size() * (model_steps + 1));
  for (const MissingParts::Part& part : missing.parts) {
    const ScenePlace place(missing.source, false, part.character);
    StagedCharacter character = part.known;
    character.scene = missing.scene.characters[part.character];
    if (part.needs_model) {
      if (auto ok = stage_model(character, missing.scene, missing.options, place, watch); !ok)
        return pass_on(std::move(ok));
    } else {
      for (std::size_t i = 0; i < model_steps; ++i) watch.advance();
    }
    if (auto ok = add_motions(character, missing.options, missing.scene.fps, place, missing.motions, watch); !ok)
      return pass_on(std::move(ok));
    watch.advance();
    if (auto ok = watch.check(); !ok) return pass_on(std::move(ok));
    if (character.motion) made.motions.push_back(*std::exchange(character.motion, std::nullopt));
    made.motions.insert(made.motions.end(), character.emotions.begin(), character.emotions.end());
    character.emotions.clear();
    if (part.needs_model) made.models.push_back(std::move(character));
  }
  return made;
}

void lend(StageParts parts, Stage& stage) {
  stage.spare.insert(stage.spare.begin(), std::move_iterator(parts.models.begin()),
                     std::move_iterator(parts.models.end()));
  stage.spare_motions.insert(stage.spare_motions.begin(), std::move_iterator(parts.motions.begin()),
                             std::move_iterator(parts.motions.end()));
}

}  // namespace sinew
