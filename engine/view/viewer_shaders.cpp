#include <spdlog/spdlog.h>

#include "engine/view/viewer_session.h"

namespace sinew {

Result<void> ViewerSession::use_shaders(std::shared_ptr<const ShaderSet> shaders) {
  device_.use_shaders(shaders);
  options_.device.shaders = std::move(shaders);
  std::vector<std::string> problems;
  if (auto ok = make_pictures(*shown_, problems); !ok) return ok;
  stale_ = true;
  // Pipelines are made when they first draw: only then does the device say what it cannot do.
  const int frame = state_.playback.shown();
  return shown_->picture->draw(frame, maker().pose(frame), state_.extras);
}

void ViewerSession::take_shaders() {
  auto compiled = shaders_.take();
  if (!compiled) return;
  const auto before = options_.device.shaders;
  Result<void> used;
  if (!*compiled)
    used = pass_on(std::move(*compiled));
  else if (used = use_shaders(std::move(**compiled)); !used)
    if (auto ok = use_shaders(before); !ok) used = std::move(ok);
  // Whoever edits a shader may look at the terminal.
  if (!used) {
    spdlog::warn("{}", used.error().message);
    return say(used.error());
  }
  spdlog::info("the shaders are compiled anew");
  say("the shaders are compiled anew");
}

}  // namespace sinew
