#pragma once
/// The shaders, compiled when the program was built.

#include <cstdint>
#include <span>

namespace sinew {

enum class Shader {
  deform_texel,
  deform_storage,
  deform_bare_texel,
  deform_bare_storage,
  surface_vertex,
  surface_fragment,
};

/// SPIR-V words.
std::span<const std::uint32_t> shader_code(Shader shader);

}  // namespace sinew
