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
  surface_rich_vertex,
  surface_rich_fragment,
  surface_behind_fragment,
  surface_behind_fragment_multisampled,
  peel_fragment,
  peel_fragment_multisampled,
  depth_vertex,
  masked_depth_vertex,
  masked_depth_fragment,
  contact_vertex,
  contact_fragment,
  floor_vertex,
  floor_fragment,
  wire_vertex,
  wire_fragment,
};

/// SPIR-V words.
std::span<const std::uint32_t> shader_code(Shader shader);

}  // namespace sinew
