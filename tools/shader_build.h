#pragma once
/// Whether this program compiles shaders while it runs.

#include "engine/view/shader_reload.h"

namespace sinew::tools {

/// The project's own shaders and their compiler in a developer's build (CMake: SINEW_SHADER_RELOAD); nothing in others.
ShaderBuild shader_build();

}  // namespace sinew::tools
