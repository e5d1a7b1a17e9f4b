#include "engine/app/character_motions.h"

#include "engine/app/emotion_use.h"

namespace sinew {
SceneOptions options_of(const Scene& scene, SceneOptions options) {
  if (scene.library) options.library = *scene.library;
  return options;
}

std::vector<MotionOrigin> motion_origins(const Character& character, const SceneOptions& options, double fps,
                                         const std::string& model_hash) {
  std::vector<MotionOrigin> origins;
  if (character.motion) {
    const auto* file = std::get_if<MotionFile>(&character.motion->source);
    origins.push_back({character.motion->source, 0.0,
                       file_state(file != nullptr ? file->path : library_or_default(options.library)), model_hash});
  }
  for (const EmotionCue& cue : character.emotion)
    origins.push_back({cue, fps, file_state(library_or_default(options.library)), model_hash});
  return origins;
}

const StagedMotion* find_motion(const KnownMotions& known, const MotionOrigin& origin) {
  const auto found = std::ranges::find(known, origin, &StagedMotion::origin);
  return found == known.end() ? nullptr : &*found;
}

Result<void> add_motions(StagedCharacter& character, const SceneOptions& options, double fps, const ScenePlace& place,
                         const KnownMotions& known, const TaskWatch& watch) {
  std::optional<MotionLibrary> library;  // of the emotions
  for (const MotionOrigin& origin : motion_origins(character.scene, options, fps, character.model_hash)) {
    const StagedMotion* before = find_motion(known, origin);
    Result<StagedMotion> made = before != nullptr ? *before : StagedMotion{};
    if (const auto* cue = std::get_if<EmotionCue>(&origin.asked)) {
      if (before == nullptr && !library) {
        auto opened = MotionLibrary::open(library_or_default(options.library), false);
        if (!opened) return place.at("/emotion", std::move(opened));
        library = std::move(*opened);
      }
      if (before == nullptr) made = stage_emotion(*cue, *library, fps, *character.model, character.humanoid);
      if (!made) return place.at(fmt::format("/emotion/{}", character.emotions.size()), std::move(made));
      character.emotions.push_back(std::move(*made));
      character.emotions.back().origin = origin;
      continue;
    }
    if (before == nullptr)
      made = stage_motion(*character.scene.motion, options.library, *character.model, character.humanoid, watch);
    if (!made) return place.at("/motion", std::move(made));
    character.motion = std::move(*made);
    character.motion->use = *character.scene.motion;
    character.motion->origin = origin;
  }
  return {};
}

}  // namespace sinew
