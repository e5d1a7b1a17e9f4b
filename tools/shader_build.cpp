#include "tools/shader_build.h"

#ifdef SINEW_SHADER_FOLDER
#include "engine/gpu/shader_compiler.h"
#endif

namespace sinew::tools {

ShaderBuild shader_build() {
#ifdef SINEW_SHADER_FOLDER
  return {SINEW_SHADER_FOLDER, compile_shaders};
#else
  return {};
#endif
}

}  // namespace sinew::tools
