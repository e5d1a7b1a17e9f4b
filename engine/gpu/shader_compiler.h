#pragma once
/// Compiles shaders while the program runs, as the build's glslangValidator does: the same words come of the same
/// source. A library of its own (CMake: sinew_shader_compiler), which developers' programs link.

#include <filesystem>

#include "engine/core/task_watch.h"
#include "engine/gpu/shader_code.h"

namespace sinew {

/// The SPIR-V words of one source in `folder`, where its includes are looked for too. Fails as bad_input with file,
/// line and the compiler's words.
Result<std::vector<std::uint32_t>> compile_shader(const ShaderSource& source, const std::filesystem::path& folder);

/// Every shader of shader_sources(), the watch counting them; stops at the first that fails.
Result<ShaderSet> compile_shaders(const std::filesystem::path& folder, TaskWatch& watch);

}  // namespace sinew
