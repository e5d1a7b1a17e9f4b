#pragma once
/// All motions that a scene's character plays, those made before used again.

#include "engine/app/scene_place.h"
#include "engine/app/stage.h"

namespace sinew {

/// Motions that were made, for whoever may use them again.
using KnownMotions = std::vector<StagedMotion>;

/// The options that hold for a scene: the library that it names goes before that of the command line.
SceneOptions options_of(const Scene& scene, SceneOptions options);

/// What the character's motion and each of its emotions are made from, in this order.
std::vector<MotionOrigin> motion_origins(const Character& character, const SceneOptions& options, double fps,
                                         const std::string& model_hash);

/// The motion of that origin; null where there is none.
const StagedMotion* find_motion(const KnownMotions& known, const MotionOrigin& origin);

/// Puts the motion and the emotions of `character.scene` onto its model, which is there already. Fails as
/// stage_motion() and stage_emotion() do.
Result<void> add_motions(StagedCharacter& character, const SceneOptions& options, double fps, const ScenePlace& place,
                         const KnownMotions& known, const TaskWatch& watch);

}  // namespace sinew
