#pragma once
/// Edits that work on frames and fit curves anew; see motion_edit.h.

#include "engine/io/json_reader.h"
#include "engine/motion/motion_edit.h"

namespace sinew {

/// warp with times, loop, join, cross_fade, layer and mirror. What is wrong is reported to `edit`.
void edit_frames(EditedMotion& motion, const JsonValue& edit, const std::string& operation, const ClipSource& clips);

}  // namespace sinew
