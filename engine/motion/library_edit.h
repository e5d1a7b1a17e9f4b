#pragma once
/// Edits as operations on a library: a new clip that names its parent and how it was made.

#include <nlohmann/json.hpp>

#include "engine/motion/library.h"
#include "engine/motion/motion_edit.h"

namespace sinew {

/// Adds the clip `name`: `parent` with the edits applied. A parent without curves is edited on curves within
/// refit_tolerance; they are not kept. The new clip has the parent's tags, emotion, source and licence, samples taken
/// from its curves, and an apex that is found anew. Fails as bad_input, and the library is as it was.
Result<StoredClip> edit_clip(MotionLibrary& library, const std::string& parent, const std::string& name,
                             const nlohmann::json& edits, bool replace);

/// All edits that made a clip from the one that was imported, first to last. Fails as bad_input where there is no such
/// clip or it was not made by edits.
Result<nlohmann::json> edits_of(const MotionLibrary& library, const std::string& name);

}  // namespace sinew
