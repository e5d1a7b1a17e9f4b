#include "engine/view/shader_reload.h"

#include <utility>

namespace sinew {

ShaderReload::ShaderReload(ShaderBuild build) : build_(std::move(build)) {
  // A program that was carried elsewhere has no sources beside it.
  if (!std::filesystem::is_directory(build_.folder)) build_.compile = {};
  if (!build_.compile) return;
  due_ = true;
  watch_.watch(build_.folder);
  for (const ShaderSource& source : shader_sources()) {
    const auto carried = shader_code(source.shader);
    in_use_[source.shader].assign(carried.begin(), carried.end());
  }
}

bool ShaderReload::follow() {
  if (!build_.compile || is_busy()) return false;
  const bool changed = watch_.has_changed();
  if (!std::exchange(due_, false) && !changed) return false;
  return task_.start("compiling shaders",
                     [build = build_](TaskWatch& watch) { return build.compile(build.folder, watch); });
}

std::optional<Result<std::shared_ptr<const ShaderSet>>> ShaderReload::take() {
  auto compiled = task_.take();
  if (!compiled) return std::nullopt;
  const bool failed_before = std::exchange(failed_, !*compiled);
  if (failed_) return pass_on(std::move(*compiled));
  // After a failure people wait to hear that all is well.
  if (**compiled == in_use_ && !failed_before) return std::nullopt;
  in_use_ = **compiled;
  return std::make_shared<const ShaderSet>(std::move(**compiled));
}

}  // namespace sinew
