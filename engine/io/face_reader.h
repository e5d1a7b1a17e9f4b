#pragma once
/// What a scene's character says of its face.

#include <filesystem>

#include "engine/io/json_reader.h"
#include "engine/model/scene.h"

namespace sinew {

/// Reads "head", "expressions", "regions" and "emotion" of one item of "characters".
void read_face(const JsonValue& character_value, const std::filesystem::path& folder, Character& character);

}  // namespace sinew
