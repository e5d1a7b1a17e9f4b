#pragma once
/// Scene files: JSON with comments, as scenes/scene.schema.json describes them.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/model/scene.h"

namespace sinew {

/// The scene in `file`. Fails as bad_input with the file, the JSON pointer (or line and column), what is wrong and what
/// would be right. Nothing that the scene names is opened; its relative paths are resolved against the file's folder.
Result<Scene> read_scene(const std::filesystem::path& file);

/// The scene in `text`; `name` stands for the file in messages, relative paths are resolved against `folder`.
Result<Scene> parse_scene(std::string_view text, const std::string& name, const std::filesystem::path& folder);

/// True for JSON whose top level has "sinew" or "characters", right or wrong otherwise; false for glTF and all else.
bool looks_like_scene(std::span<const unsigned char> bytes);

/// The scene as parse_scene() reads it back: keys in the order of the schema, paths relative to `folder` where they can
/// be, what is at its default left out. Numbers come back exactly.
std::string scene_text(const Scene& scene, const std::filesystem::path& folder);

}  // namespace sinew
