#include "engine/view/playback.h"

namespace sinew {

bool Playback::toggle() {
  if (range.first >= range.last) {
    playing = false;
    return false;
  }
  playing = !playing;
  if (playing && repeat == Repeat::once && frame >= range.last) frame = range.first;
  return true;
}

void Playback::advance(double seconds, double fps) {
  if (!playing) return;
  const double first = range.first, length = range.last - range.first;
  if (length <= 0.0) {
    playing = false;
    return;
  }
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
