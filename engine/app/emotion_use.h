#pragma once
/// A scene's emotions on a character: for each a clip of the motion library and an expression, apex on apex.

#include "engine/app/motion_use.h"

namespace sinew {

/// The clip that stands for an emotion: of the library's clips of that emotion, or else of those tagged with its name,
/// the first by name. Fails as bad_input with the emotions that there are where there is none.
Result<StoredClip> clip_of_emotion(const MotionLibrary& library, Expression emotion);

/// Where a clip plays so that its apex, `apex` seconds from its begin, falls on the cue's frame: its weight rises from
/// 0 to the cue's strength within 0.3 s of its begin, not after its apex, and falls in the same way at its end.
MotionUse use_for_cue(const EmotionCue& cue, const ClipEntry& clip, double apex, double fps);

/// The expressions that cues ask for, added to those that the scene has: each at its cue's frame, neutral where its
/// clip (`uses`, one a cue) begins and ends. The scene's own keys go before: at their own frame they stay, and between
/// a clip's begin or end and its apex they stand in place of neutral.
std::optional<Keyed<ExpressionWeight>> expressions_with(const std::optional<Keyed<ExpressionWeight>>& own,
                                                        std::span<const EmotionCue> cues,
                                                        std::span<const MotionUse> uses);

/// Finds a cue's clip in the library and puts it onto the model.
Result<StagedMotion> stage_emotion(const EmotionCue& cue, const MotionLibrary& library, double fps, const Model& model,
                                   const Humanoid& humanoid, std::vector<std::string>& problems);

}  // namespace sinew
