#include "engine/gpu/shader_code.h"

namespace sinew {
namespace {
#include "shaders/contact_fragment.spv.h"
#include "shaders/contact_vertex.spv.h"
#include "shaders/deform_bare_storage.spv.h"
#include "shaders/deform_bare_texel.spv.h"
#include "shaders/deform_storage.spv.h"
#include "shaders/deform_texel.spv.h"
#include "shaders/depth_vertex.spv.h"
#include "shaders/floor_fragment.spv.h"
#include "shaders/floor_vertex.spv.h"
#include "shaders/masked_depth_fragment.spv.h"
#include "shaders/masked_depth_vertex.spv.h"
#include "shaders/peel_fragment.spv.h"
#include "shaders/peel_fragment_multisampled.spv.h"
#include "shaders/surface_behind_fragment.spv.h"
#include "shaders/surface_behind_fragment_multisampled.spv.h"
#include "shaders/surface_fragment.spv.h"
#include "shaders/surface_rich_fragment.spv.h"
#include "shaders/surface_rich_vertex.spv.h"
#include "shaders/surface_vertex.spv.h"
#include "shaders/wire_fragment.spv.h"
#include "shaders/wire_vertex.spv.h"
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
    case Shader::surface_rich_vertex:
      return surface_rich_vertex;
    case Shader::surface_rich_fragment:
      return surface_rich_fragment;
    case Shader::surface_behind_fragment:
      return surface_behind_fragment;
    case Shader::surface_behind_fragment_multisampled:
      return surface_behind_fragment_multisampled;
    case Shader::peel_fragment:
      return peel_fragment;
    case Shader::peel_fragment_multisampled:
      return peel_fragment_multisampled;
    case Shader::depth_vertex:
      return depth_vertex;
    case Shader::masked_depth_vertex:
      return masked_depth_vertex;
    case Shader::masked_depth_fragment:
      return masked_depth_fragment;
    case Shader::contact_vertex:
      return contact_vertex;
    case Shader::contact_fragment:
      return contact_fragment;
    case Shader::floor_vertex:
      return floor_vertex;
    case Shader::floor_fragment:
      return floor_fragment;
    case Shader::wire_vertex:
      return wire_vertex;
    case Shader::wire_fragment:
      return wire_fragment;
  }
  return {};
}

}  // namespace sinew
