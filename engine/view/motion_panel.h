#pragma once
/// What the motion panel shows and what the user did in it.

#include <optional>

#include "engine/view/motion_browser.h"
#include "engine/view/plot_scale.h"

namespace sinew {

enum class CurveSource {
  clip,  ///< the fitted curves of a clip of the library
  keys,  ///< the scene's keys of the chosen joint
};

struct MotionPanel {
  bool shown = false;
  bool edited_last = false;  ///< the clip was edited since the scene was: undo takes that back first
  MotionBrowser browser;
  float tolerance = 0.5f;  ///< degrees, of the next fit
  std::string save_as;     ///< the edited clip's name

  CurveSource source = CurveSource::clip;
  CurveChoice choice;  ///< of the open clip
  int axis = 0;        ///< of the scene's keys

  /// What is being dragged on the plot.
  struct Drag {
    std::size_t key = 0;
    bool slope = false;
    PlotScale scale;       ///< as it was when the drag began: what moves under the pointer cannot be aimed with
    Vec2 from{0.0};        ///< the key in the plot's units as it was then
    bool in_time = false;  ///< it has gone so far along the time that this is meant
  };
  std::optional<Drag> drag;
  std::optional<PlotRange> zoom;  ///< the part of the time that is shown; absent: all
};

}  // namespace sinew
