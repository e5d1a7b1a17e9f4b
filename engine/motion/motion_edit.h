#pragma once
/// Edits of fitted motions by their curves' parameters. An edit is JSON, so that a library can keep it and replay it.

#include <functional>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "engine/core/result.h"
#include "engine/motion/curve_clip.h"

namespace sinew {

/// A motion that is being edited.
struct EditedMotion {
  MotionSkeleton skeleton;
  CurveClip curves;
};

/// Gives another clip of the library by name, for edits that join two.
using ClipSource = std::function<Result<EditedMotion>(const std::string& name)>;

/// Applies a list of edits, each {"operation": NAME, ...}:
///
/// | operation | keys |
/// | --- | --- |
/// | set_key | joint, axis, time, value; slope: the key there gets this value, and slope if given |
/// | add_key | joint, axis, time; value, slope: a cut there, the curve's own value and slope where none are given |
/// | move_key | joint, axis, time, to: the key goes to another time between its neighbours |
/// | delete_key | joint, axis, time: the two segments beside it become one |
/// | scale | joint, factor; axis: the deviation from the first pose |
/// | offset | joint, axis, degrees |
/// | warp | factor: everything takes so many times as long; or times [[from, to], ...]: piecewise linear, rising |
/// | crop | from, to |
/// | loop | count, blend: the end runs into the begin over `blend` seconds |
/// | join | clip, blend: another clip after this one, the two overlapping by `blend` seconds |
/// | cross_fade | clip, from, to: this clip until one time, the other from another on |
/// | layer | clip, joints: these joints, and all below them, from another clip |
/// | mirror | left and right exchanged |
///
/// `joint` is a joint's or a humanoid name, or "root" for the root's place; `axis` is x, y or z; times in seconds,
/// values in degrees (of the root's place: lengths), slopes a second. A key is found within half a frame. From warp
/// with times on, edits work on frames, and curves are fitted anew within `refit_tolerance` degrees. Fails as bad_input
/// with the JSON pointer, or the nearest known name; then `motion` is as it was.
Result<void> apply_edits(EditedMotion& motion, const nlohmann::json& edits, const ClipSource& clips);

constexpr double refit_tolerance = 0.1;

/// The index of the joint called by its own or its humanoid name. Fails as bad_input with the nearest known name.
Result<int> find_motion_joint(const MotionSkeleton& skeleton, const std::string& name);

/// Names of the operations.
std::span<const std::string> edit_operations();

}  // namespace sinew
