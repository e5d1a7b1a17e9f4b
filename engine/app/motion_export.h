#pragma once
/// Motions as files of other programs.

#include <filesystem>
#include <optional>

#include "engine/core/files.h"
#include "engine/core/result.h"
#include "engine/model/motion.h"

namespace sinew {

/// The motion as the file of that name would hold it: `.bvh`; `.vrma`, on a T-pose skeleton of its own bones; or
/// `.glb`, an animation of `model`, a glTF file or a built-in model's name. Fails as usage where the extension is none
/// of these or a `.glb` has no model, else as bad_input.
Result<Bytes> motion_file_bytes(const Motion& motion, const std::filesystem::path& output,
                                const std::optional<std::filesystem::path>& model = std::nullopt);

/// motion_file_bytes(), written. Fails also as cannot_write; nothing half-written is left.
Result<void> export_motion(const Motion& motion, const std::filesystem::path& output,
                           const std::optional<std::filesystem::path>& model = std::nullopt);

}  // namespace sinew
