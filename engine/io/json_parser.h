#pragma once
/// JSON files that people write, parsed with limits and with faults that say where they are.

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "engine/core/result.h"

namespace sinew {

/// What a document may cost. The defaults are far beyond what people and scripts write, and cheap to hold in memory.
struct JsonLimits {
  std::size_t bytes = std::size_t{64} << 20;
  std::size_t depth = 64;          ///< objects and lists inside each other
  std::size_t values = 8'000'000;  ///< of any kind, altogether
};

/// The document in `text`; comments are allowed, trailing commas and a key twice in one object are not. Fails as
/// bad_input, `name` first, with line and column where the text is no JSON.
Result<nlohmann::json> parse_json(std::string_view text, const std::string& name, const JsonLimits& limits = {});

/// The pointer one step further down (RFC 6901): "/" and the key with ~ and / escaped.
std::string json_pointer(std::string_view parent, std::string_view key);

}  // namespace sinew
