#include "engine/app/stage_use.h"

#include "engine/app/emotion_use.h"
#include "engine/model/scene_words.h"
#include "engine/rig/clip_sampling.h"

namespace sinew {
namespace {

Result<void> choose_clip(StagedCharacter& character, const SceneOptions& options, bool bare_model,
                         const ScenePlace& place) {
  std::optional<ClipChoice> choice = options.clip ? options.clip : character.scene.clip;
  if (!choice && bare_model && !character.model->clips.empty()) choice = 0;
  if (!choice) return {};
  auto clip = find_clip(*character.model, *choice);
  if (!clip) return options.clip ? pass_on(std::move(clip)) : place.at("/clip", std::move(clip));
  character.clip = *clip;
  return {};
}

Result<void> find_tracks(StagedCharacter& character, const ScenePlace& place) {
  for (const auto& [joint, keys] : character.scene.keys) {
    auto node = find_joint(*character.model, character.humanoid, joint);
    if (!node) return place.at("/keys/" + joint, std::move(node));
    const bool added = character.scene.motion && character.scene.motion->keys == KeyBlend::add;
    character.tracks.push_back({*node, keys, added});
  }
  return {};
}

Result<void> place_muscles(StagedCharacter& character, bool bare_model, const ScenePlace& place,
                           std::vector<std::string>& problems) {
  const PlacementContext context{*character.model, character.mesh, character.rest, character.humanoid};
  if (bare_model) {
    character.muscles = default_muscles(context, problems);
    return {};
  }
  for (std::size_t i = 0; i < character.scene.muscles.size(); ++i) {
    auto placed = place_muscle(context, character.scene.muscles[i]);
    if (!placed) return place.at(fmt::format("/muscles/{}", i), std::move(placed));
    character.muscles.push_back(std::move(*placed));
  }
  return {};
}

Result<void> add_emotions(StagedCharacter& character, const SceneOptions& options, double fps, const ScenePlace& place,
                          std::vector<std::string>& problems) {
  const std::vector<EmotionCue>& cues = character.scene.emotion;
  if (cues.empty()) return {};
  auto library = MotionLibrary::open(options.library.empty() ? default_library() : options.library, false);
  if (!library) return place.at("/emotion", std::move(library));
  std::vector<EmotionSpan> spans;
  for (std::size_t i = 0; i < cues.size(); ++i) {
    auto staged = stage_emotion(cues[i], *library, fps, *character.model, character.humanoid, problems);
    if (!staged) return place.at(fmt::format("/emotion/{}", i), std::move(staged));
    character.emotions.push_back(std::move(staged->motion));
    spans.push_back(staged->span);
  }
  character.scene.expressions = expressions_with(character.scene.expressions, cues, spans);
  return {};
}

}  // namespace

Result<void> stage_use(StagedCharacter& character, const SceneOptions& options, bool bare_model, double fps,
                       const ScenePlace& place, std::vector<std::string>& problems) {
  std::vector<std::string> found = character.model->problems;
  found.insert(found.end(), character.face.problems.begin(), character.face.problems.end());
  if (auto ok = choose_clip(character, options, bare_model, place); !ok) return ok;
  if (const auto& use = character.scene.motion) {
    auto motion = stage_motion(*use, options.library, *character.model, character.humanoid, found);
    if (!motion) return place.at("/motion", std::move(motion));
    character.motion = std::move(*motion);
  }
  const bool has_face_of_emotions_alone = !character.scene.emotion.empty() && !character.scene.expressions &&
                                          character.scene.cues.empty() && character.scene.regions.empty();
  if (auto ok = add_emotions(character, options, fps, place, found); !ok) return ok;
  if (auto ok = find_tracks(character, place); !ok) return ok;
  if (auto ok = stage_face(character.scene, *character.model, character.mesh, character.face); !ok) {
    if (!has_face_of_emotions_alone) return place.inside("", std::move(ok));
    found.push_back("has no face that could show its emotions; its body does");
    character.scene.expressions.reset();
  }
  if (auto ok = place_muscles(character, bare_model, place, found); !ok) return ok;
  if (character.mesh.triangles.empty()) found.push_back("has no triangles; nothing of it is shown");
  for (const PlacedMuscle& placed : character.muscles)
    for (std::string& problem : placement_problems(placed)) found.push_back(std::move(problem));
  for (const std::string& problem : found)
    problems.push_back(fmt::format("{}: {}", character.scene.model.string(), problem));
  return {};
}

}  // namespace sinew
