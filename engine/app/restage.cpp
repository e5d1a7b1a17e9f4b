#include "engine/app/complete_stage.h"
#include "engine/app/stage_model.h"
#include "engine/app/stage_parts.h"
#include "engine/app/stage_use.h"

namespace sinew {
namespace {

/// Kept for undoing and redoing.
constexpr std::size_t most_spare_models = 6, most_spare_motions = 6;

}  // namespace

Result<void> restage(Stage& stage, const Scene& scene, const SceneOptions& options) {
  Stage next;
  next.source = stage.source;
  next.scene = scene;
  next.strength = options.strength;
  const SceneOptions with_library = options_of(scene, options);
  KnownMotions motions = known_motions(stage);
  TaskWatch unwatched;
  std::vector<StagedCharacter*> known;
  for (std::vector<StagedCharacter>* list : {&stage.characters, &stage.spare})
    for (StagedCharacter& character : *list) known.push_back(&character);
  // Each model serves once; it goes back where it came from if the new scene cannot be staged.
  std::vector<StagedCharacter*> taken_from;
  const auto fail = [&](Error error) -> Result<void> {
    for (std::size_t i = 0; i < taken_from.size(); ++i)
      if (taken_from[i]) {
        StagedCharacter& lent = next.characters[i];
        taken_from[i]->model = std::move(lent.model);
        taken_from[i]->mesh = std::move(lent.mesh);
        taken_from[i]->rest = std::move(lent.rest);
      }
    return tl::unexpected<Error>(std::move(error));
  };
  for (const Character& character : scene.characters) {
    const ScenePlace place(stage.source, false, next.characters.size());
    StagedCharacter& staged = next.characters.emplace_back();
    staged.scene = character;
    const auto old = std::ranges::find_if(
        known, [&](const StagedCharacter* candidate) { return has_model_of(*candidate, character); });
    if (old != known.end()) {
      taken_from.push_back(*old);
      staged.model = std::move((*old)->model);
      staged.model_hash = (*old)->model_hash;
      staged.order = (*old)->order;
      staged.rest_rotations = (*old)->rest_rotations;
      staged.humanoid = (*old)->humanoid;
      staged.mesh = std::move((*old)->mesh);
      staged.rest = std::move((*old)->rest);
      staged.face.head = (*old)->face.head;
      staged.face.worn = (*old)->face.worn;
      staged.face.landmarks = (*old)->face.landmarks;
      staged.face.problems = (*old)->face.problems;
    } else {
      taken_from.push_back(nullptr);
      if (auto ok = stage_model(staged, scene, with_library, place, unwatched); !ok) return fail(ok.error());
    }
    if (auto ok = stage_use(staged, with_library, false, scene.fps, place, motions, next.problems, unwatched); !ok)
      return fail(ok.error());
  }
  if (auto ok = complete_stage(next, options); !ok) return fail(ok.error());
  for (StagedCharacter* left : known)
    if (left->model && next.spare.size() < most_spare_models) next.spare.push_back(std::move(*left));
  const KnownMotions played = known_motions(next);
  std::erase_if(motions, [&](const StagedMotion& motion) { return find_motion(played, motion.origin) != nullptr; });
  if (motions.size() > most_spare_motions) motions.erase(motions.begin() + most_spare_motions, motions.end());
  next.spare_motions = std::move(motions);
  stage = std::move(next);
  return {};
}

}  // namespace sinew
