#include "engine/view/playback.h"

namespace sinew {

void Playback::advance(double seconds, double fps) {
  if (!playing) return;
  const double first = range.first, length = range.last - range.first;
  if (length <= 0.0) return;
  const double steps = seconds * fps * speed;
  switch (repeat) {
    case Repeat::once:
      frame = std::min(frame + steps, first + length);
      playing = frame < first + length;
      break;
    case Repeat::loop:
      // The last frame is shown as long as every other.
      frame = first + std::fmod(frame - first + steps, length + 1.0);
      break;
    case Repeat::ping_pong: {
      const double gone = backwards ? 2.0 * length - (frame - first) : frame - first;
      const double place = std::fmod(gone + steps, 2.0 * length);
      backwards = place > length;
      frame = first + (backwards ? 2.0 * length - place : place);
      break;
    }
  }
}

}  // namespace sinew
