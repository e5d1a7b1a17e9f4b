#pragma once
/// What a scene's character says of its face, as JSON: the way back from face_reader.h.

#include <filesystem>

#include "engine/io/keyed_writer.h"

namespace sinew {

/// Adds "head", "expressions", "regions" and "emotion" to a character's object, where they are not at their defaults.
void write_face(const Character& character, const std::filesystem::path& folder, ordered_json& object);

}  // namespace sinew
