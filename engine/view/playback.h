#pragma once
/// Time in a viewer: which frame is shown now. No Vulkan, no clock of its own.

#include <algorithm>
#include <cmath>

#include "engine/model/scene.h"

namespace sinew {

enum class Repeat { once, loop, ping_pong };

/// What there is to say where a scene has one frame.
constexpr const char* nothing_to_play = "nothing to play: the scene has one frame; key a joint or choose a motion";

struct Playback {
  FrameSpan range;
  double frame = 0.0;  ///< shown, within the range
  bool playing = false;
  bool backwards = false;  ///< on the way back of ping-pong
  double speed = 1.0;      ///< > 0
  Repeat repeat = Repeat::loop;

  /// The whole frame that is shown: pictures are those that files of this scene hold.
  int shown() const { return static_cast<int>(std::floor(frame + 1e-9)); }

  void set_range(const FrameSpan& span) {
    range = span;
    frame = std::clamp<double>(frame, range.first, range.last);
  }
  void go_to(double wanted) { frame = std::clamp<double>(wanted, range.first, range.last); }

  /// Plays, from the beginning where it has come to its end, or pauses. False where there is one frame: nothing plays.
  bool toggle();

  /// Lets `seconds` pass at `fps` frames a second.
  void advance(double seconds, double fps);
};

}  // namespace sinew
