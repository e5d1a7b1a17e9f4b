#pragma once
/// What a glTF file points to: data URIs and files beside it (glTF 2.0 section 2.8).

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/files.h"
#include "engine/core/result.h"

namespace sinew::gltf {

/// "%20" and the like as bytes; nothing where a percent sign is not followed by two hexadecimal digits.
std::optional<std::string> decode_percent(std::string_view text);

/// Base64 (RFC 4648; the padding may be missing); nothing where the text is none.
std::optional<Bytes> decode_base64(std::string_view text);

/// The bytes behind a URI: "data:...;base64,..." or a path relative to `folder`. Fails as bad_input for other schemes
/// and for files that are missing, no regular files, or longer than `limit` bytes.
Result<Bytes> read_uri(std::string_view uri, const std::filesystem::path& folder, std::size_t limit);

}  // namespace sinew::gltf
