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

/// Of its deviation at the apex, what a body that is near it has at the least; the face's share of its strength there.
constexpr double near_apex = 0.8;

EmotionSpan span_of(const Motion& motion, const MotionUse& use, double apex, double fps);

/// The expressions that cues ask for, added to those that the scene has: each at its cue's frame, near_apex of it where
/// the body comes near its apex and leaves it, neutral where the clip begins and ends. `spans`: one a cue. The scene's
/// own keys go before: where one stands between a clip's begin or end and its apex, the clip adds nothing on that side.
std::optional<Keyed<ExpressionWeight>> expressions_with(const std::optional<Keyed<ExpressionWeight>>& own,
                                                        std::span<const EmotionCue> cues,
                                                        std::span<const EmotionSpan> spans);

/// Finds a cue's clip in the library and puts it onto the model.
Result<StagedMotion> stage_emotion(const EmotionCue& cue, const MotionLibrary& library, double fps, const Model& model,
                                   const Humanoid& humanoid);

}  // namespace sinew
