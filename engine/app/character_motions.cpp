#include "engine/app/character_motions.h"

#include "engine/app/emotion_use.h"

namespace sinew {
namespace {

std::filesystem::path library_file(const SceneOptions& options) {
  return options.library.empty() ? default_library() : options.library;
}

Result<StagedMotion> make_motion(const MotionOrigin& origin, const StagedCharacter& character,
                                 const SceneOptions& options, double fps, const TaskWatch& watch) {
  if (std::holds_alternative<MotionChoice>(origin.asked))
    return stage_motion(*character.scene.motion, options.library, *character.model, character.humanoid, watch);
  const auto library = MotionLibrary::open(library_file(options), false);
  if (!library) return tl::unexpected<Error>(library.error());
  return stage_emotion(std::get<EmotionCue>(origin.asked), *library, fps, *character.model, character.humanoid);
}

}  // namespace

SceneOptions options_of(const Scene& scene, SceneOptions options) {
  if (scene.library) options.library = *scene.library;
  return options;
}

std::vector<MotionOrigin> motion_origins(const Character& character, const SceneOptions& options, double fps,
                                         const std::string& model_hash) {
  std::vector<MotionOrigin> origins;
  if (character.motion) {
    const auto* file = std::get_if<MotionFile>(&character.motion->source);
    origins.push_back(
        {character.motion->source, 0.0, file_state(file != nullptr ? file->path : library_file(options)), model_hash});
  }
  for (const EmotionCue& cue : character.emotion)
    origins.push_back({cue, fps, file_state(library_file(options)), model_hash});
  return origins;
}

const StagedMotion* find_motion(const KnownMotions& known, const MotionOrigin& origin) {
  const auto found = std::ranges::find(known, origin, &StagedMotion::origin);
  return found == known.end() ? nullptr : &*found;
}

Result<void> add_motions(StagedCharacter& character, const SceneOptions& options, double fps, const ScenePlace& place,
                         const KnownMotions& known, const TaskWatch& watch) {
  for (const MotionOrigin& origin : motion_origins(character.scene, options, fps, character.model_hash)) {
    const bool is_motion = std::holds_alternative<MotionChoice>(origin.asked);
    const StagedMotion* before = find_motion(known, origin);
    auto made = before != nullptr ? Result<StagedMotion>(*before) : make_motion(origin, character, options, fps, watch);
    if (!made)
      return place.at(is_motion ? "/motion" : fmt::format("/emotion/{}", character.emotions.size()), std::move(made));
    made->origin = origin;
    if (!is_motion) {
      character.emotions.push_back(std::move(*made));
      continue;
    }
    made->use = *character.scene.motion;
    character.motion = std::move(*made);
  }
  return {};
}

}  // namespace sinew
