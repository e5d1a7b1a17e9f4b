#include "engine/gpu/shader_code.h"

namespace sinew {
namespace {
#include "shaders/deform_bare_storage.spv.h"
#include "shaders/deform_bare_texel.spv.h"
#include "shaders/deform_storage.spv.h"
#include "shaders/deform_texel.spv.h"
#include "shaders/surface_fragment.spv.h"
#include "shaders/surface_vertex.spv.h"
}  // namespace

std::span<const std::uint32_t> shader_code(Shader shader) {
  switch (shader) {
    case Shader::deform_texel:
      return deform_texel;
    case Shader::deform_storage:
      return deform_storage;
    case Shader::deform_bare_texel:
      return deform_bare_texel;
    case Shader::deform_bare_storage:
      return deform_bare_storage;
    case Shader::surface_vertex:
      return surface_vertex;
    case Shader::surface_fragment:
      return surface_fragment;
  }
  return {};
}

}  // namespace sinew
