#include "engine/view/display_loss.h"

#include <cstdlib>
#include <utility>

#include "engine/core/result.h"

#ifdef SINEW_X11
#include <X11/Xlib.h>
#endif

namespace sinew {

#ifdef SINEW_X11
namespace {

std::function<void()> words;

int end(Display*) {
  // They may meet the broken connection again.
  if (const auto said = std::exchange(words, nullptr)) said();
  std::_Exit(static_cast<int>(ErrorKind::device_failed));
}

}  // namespace

DisplayLoss::DisplayLoss(std::function<void()> last_words) {
  words = std::move(last_words);
  XSetIOErrorHandler(end);
}

DisplayLoss::~DisplayLoss() { words = nullptr; }
#else
DisplayLoss::DisplayLoss(std::function<void()>) {}
DisplayLoss::~DisplayLoss() = default;
#endif

}  // namespace sinew
