#pragma once
/// The characters of a scene file.

#include <filesystem>
#include <string>

#include "engine/io/json_reader.h"
#include "engine/model/scene.h"

namespace sinew {

/// A path as a scene in `folder` means it: absolute paths and built-in models' names stay as they are.
std::filesystem::path resolved_path(const std::string& written, const std::filesystem::path& folder);

/// One item of "characters"; errors go to the value's report.
Character read_character(const JsonValue& value, const std::filesystem::path& folder);

/// One item of "muscles".
MuscleSpec read_muscle(const JsonValue& value);

}  // namespace sinew
