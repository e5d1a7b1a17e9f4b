#pragma once
/// Motions from any file that holds one.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/files.h"
#include "engine/core/result.h"
#include "engine/model/motion.h"

namespace sinew {

enum class MotionFormat : unsigned char { bvh, asf, amc, gltf };

/// What the bytes hold, told by their beginning, or by the file's extension; nothing: no motion that is known.
std::optional<MotionFormat> motion_format(const std::filesystem::path& file, std::span<const unsigned char> bytes);

/// All motions of a file: one of a BVH or AMC file, one a clip of a glTF, VRM or VRM animation file. An ASF file gives
/// its rest pose, and AMC its skeleton from the ASF file beside it (find_asf). Fails as bad_input with the file, the
/// place, what is wrong and what would be right.
Result<std::vector<Motion>> read_motions(const std::filesystem::path& file);
Result<std::vector<Motion>> read_motions(const std::filesystem::path& file, Bytes bytes);

/// The first of them, or the one called `clip`.
Result<Motion> read_motion(const std::filesystem::path& file, const std::string& clip = "");

}  // namespace sinew
