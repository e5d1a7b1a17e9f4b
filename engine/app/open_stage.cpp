#include "engine/app/complete_stage.h"
#include "engine/app/opened_scene.h"
#include "engine/app/stage_model.h"
#include "engine/app/stage_parts.h"
#include "engine/app/stage_use.h"

namespace sinew {

Result<Stage> open_stage(const SceneOptions& options) {
  TaskWatch unwatched;
  return open_stage(options, unwatched);
}

Result<Stage> open_stage(const SceneOptions& options, TaskWatch& watch) {
  auto opened = open_scene(options.scene);
  if (!opened) return pass_on(std::move(opened));
  Stage stage;
  stage.source = options.scene.empty() ? "the embedded scene" : options.scene;
  stage.scene = std::move(opened->scene);
  stage.is_scene = !opened->bare_model;
  stage.strength = options.strength;
  if (options.fps) stage.scene.fps = *options.fps;
  const SceneOptions with_library = options_of(stage.scene, options);
  watch.begin(stage.scene.characters.size() * (model_steps + use_steps) + 1);
  for (const Character& character : stage.scene.characters) {
    const ScenePlace place(stage.source, opened->bare_model, stage.characters.size());
    StagedCharacter& staged = stage.characters.emplace_back();
    staged.scene = character;
    auto bytes = std::exchange(opened->model_bytes, std::nullopt);
    if (auto ok = stage_model(staged, stage.scene, options, place, watch, std::move(bytes)); !ok)
      return pass_on(std::move(ok));
    if (auto ok = stage_use(staged, with_library, opened->bare_model, stage.scene.fps, place, known_motions(stage),
                            stage.problems, watch);
        !ok)
      return pass_on(std::move(ok));
  }
  if (auto ok = watch.check(); !ok) return pass_on(std::move(ok));
  if (auto ok = complete_stage(stage, options); !ok) return pass_on(std::move(ok));
  watch.advance();
  return stage;
}

}  // namespace sinew
