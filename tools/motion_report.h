#pragma once
/// What `info` says of a motion file.

#include <filesystem>

#include <nlohmann/json.hpp>

#include "engine/core/result.h"

namespace sinew::tools {

/// Counts, joints, humanoid map, size and problems of the first motion in the file, and a list of all. Fails as
/// read_motions does.
Result<nlohmann::ordered_json> motion_report(const std::filesystem::path& file);

}  // namespace sinew::tools
