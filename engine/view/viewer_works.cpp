#include "engine/view/viewer_session.h"

namespace sinew {

std::vector<WorkBeside*> ViewerSession::works() {
  return {&opening_, &edits_.task(), &state_.motion.browser.task(), &binding_, &recording_, &shaders_.task()};
}

bool ViewerSession::works_beside() {
  const bool frames_all = shown_->framing.running() || (bounds_stale_ && !document().is_merging());
  return frames_all || edits_.is_busy() || std::ranges::any_of(works(), &WorkBeside::running);
}

}  // namespace sinew
