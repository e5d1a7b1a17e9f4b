#pragma once
/// Shaders compiled anew beside the window when their sources change. No Vulkan here.

#include <functional>
#include <memory>

#include "engine/gpu/shader_code.h"
#include "engine/view/file_watch.h"
#include "engine/view/task.h"

namespace sinew {

/// What developers' programs have and others lack.
struct ShaderBuild {
  std::filesystem::path folder;  ///< of the sources
  /// compile_shaders() of gpu/shader_compiler.h; empty: the program has no compiler, and its shaders stay.
  std::function<Result<ShaderSet>(const std::filesystem::path& folder, TaskWatch& watch)> compile;
};

class ShaderReload {
 public:
  explicit ShaderReload(ShaderBuild build);

  /// Starts to compile at the first call, as the sources may be newer than the program, and whenever one of them has
  /// changed; true where it did.
  bool follow();
  WorkBeside& task() { return task_; }
  /// What came of it, once; nothing where it is the code that is in use already. Fails as the compiler does.
  std::optional<Result<std::shared_ptr<const ShaderSet>>> take();

 private:
  ShaderBuild build_;
  FileWatch watch_;
  bool due_ = false;     ///< nothing has been compiled yet
  bool failed_ = false;  ///< the last time
  ShaderSet in_use_;
  Task<ShaderSet> task_;  ///< the last member: it ends first
};

}  // namespace sinew
