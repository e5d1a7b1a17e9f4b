#pragma once
/// The outer shell of a glTF file: plain JSON text, or the binary container (glTF 2.0 section 4.4).

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace sinew::gltf {

/// Views into the file's bytes, which must outlive it.
struct Container {
  std::string_view json;
  std::span<const unsigned char> binary;  ///< the BIN chunk
  bool has_binary = false;
};

/// Tells .glb from .gltf by its first bytes. Fails as bad_input where a binary container is cut short or is not of
/// version 2; what can be passed over (bytes after the end, unknown chunks twice) is noted in `problems`.
Result<Container> open_container(std::span<const unsigned char> file, std::vector<std::string>& problems);

}  // namespace sinew::gltf
