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
                           std::vector<std::string>& problems, const TaskWatch& watch) {
  const PlacementContext context = placement_context(character);
  if (bare_model) {
    character.muscles = default_muscles(context, problems);
    return {};
  }
  for (std::size_t i = 0; i < character.scene.muscles.size(); ++i) {
    if (auto ok = watch.check(); !ok) return ok;
    auto placed = place_muscle(context, character.scene.muscles[i]);
    if (!placed) return place.at(fmt::format("/muscles/{}", i), std::move(placed));
    character.muscles.push_back(std::move(*placed));
  }
  return {};
}

}  // namespace

PlacementContext placement_context(const StagedCharacter& character) {
  return {*character.model, character.mesh, character.rest, character.humanoid};
}

std::string named_problem(const StagedCharacter& character, const std::string& problem) {
  return fmt::format("{}: {}", character.scene.model.string(), problem);
}

Result<void> stage_use(StagedCharacter& character, const SceneOptions& options, bool bare_model, double fps,
                       const ScenePlace& place, const KnownMotions& known, std::vector<std::string>& problems,
                       TaskWatch& watch) {
  std::vector<std::string> found = character.model->problems;
  found.insert(found.end(), character.face.problems.begin(), character.face.problems.end());
  if (auto ok = choose_clip(character, options, bare_model, place); !ok) return ok;
  if (auto ok = add_motions(character, options, fps, place, known, watch); !ok) return ok;
  if (character.motion) found.insert(found.end(), character.motion->notes.begin(), character.motion->notes.end());
  std::vector<EmotionSpan> spans;
  for (const StagedMotion& emotion : character.emotions) {
    found.insert(found.end(), emotion.notes.begin(), emotion.notes.end());
    spans.push_back(emotion.span);
  }
  watch.advance();
  const bool has_face_of_emotions_alone = !character.scene.emotion.empty() && !character.scene.expressions &&
                                          character.scene.cues.empty() && character.scene.regions.empty();
  character.scene.expressions = expressions_with(character.scene.expressions, character.scene.emotion, spans);
  if (auto ok = find_tracks(character, place); !ok) return ok;
  if (auto ok = stage_face(character.scene, *character.model, character.mesh, character.face); !ok) {
    if (!has_face_of_emotions_alone) return place.inside("", std::move(ok));
    found.push_back("has no face that could show its emotions; its body does");
    character.scene.expressions.reset();
  }
  if (auto ok = place_muscles(character, bare_model, place, found, watch); !ok) return ok;
  if (character.mesh.triangles.empty()) found.push_back("has no triangles; nothing of it is shown");
  for (const PlacedMuscle& placed : character.muscles)
    for (std::string& problem : placement_problems(placed)) found.push_back(std::move(problem));
  for (const std::string& problem : found) problems.push_back(named_problem(character, problem));
  watch.advance();
  return {};
}

}  // namespace sinew
