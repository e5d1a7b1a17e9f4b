#pragma once
/// Into a .glb by hand (glTF 2.0 Specification 4.4): 12 bytes of header, then chunks of 8 bytes and their content.

#include <cstring>

#include <nlohmann/json.hpp>

#include "engine/core/files.h"

namespace sinew::test {

/// The little-endian 32-bit word at a byte.
inline std::uint32_t glb_word(const Bytes& glb, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, glb.data() + at, sizeof value);
  return value;
}

/// The JSON chunk.
inline nlohmann::json glb_json(const Bytes& glb) {
  return nlohmann::json::parse(glb.begin() + 20, glb.begin() + 20 + glb_word(glb, 12));
}

}  // namespace sinew::test
