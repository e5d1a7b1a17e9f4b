#include "engine/gpu/shader_code.h"

namespace sinew {
namespace {
#include "shaders/shader_words.h"
}  // namespace

std::span<const std::uint32_t> shader_code(Shader shader) {
  switch (shader) {
#define SINEW_SHADER(name, ...) \
  case Shader::name:            \
    return name;
#include "shaders/shader_list.h"
#undef SINEW_SHADER
  }
  return {};
}

const std::vector<ShaderSource>& shader_sources() {
#define SINEW_SHADER(name, file, ...) {Shader::name, file, {__VA_ARGS__}},
  static const std::vector<ShaderSource> sources{
#include "shaders/shader_list.h"
  };
#undef SINEW_SHADER
  return sources;
}

}  // namespace sinew
