#pragma once
/// The shaders: what each is compiled from, and the code that the program carries.

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

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

/// SPIR-V words, compiled when the program was built.
std::span<const std::uint32_t> shader_code(Shader shader);

/// SPIR-V words of shaders compiled while the program runs, in place of those that it carries.
using ShaderSet = std::map<Shader, std::vector<std::uint32_t>>;

/// What a shader is compiled from.
struct ShaderSource {
  Shader shader;
  std::string file;                  ///< in the folder `shaders`; its ending says the stage
  std::vector<std::string> defines;  ///< macros that are set
};

/// Every shader, as the build's list has them (CMakeLists.txt).
const std::vector<ShaderSource>& shader_sources();

}  // namespace sinew
