#pragma once
/// The curve editor's plot: axes, dots, curves, and keys that can be dragged. ImGui's calls inside.

#include <functional>
#include <span>

#include "engine/motion/key_edit.h"
#include "engine/view/motion_panel.h"

namespace sinew {

/// What is plotted.
struct PlottedCurve {
  std::span<const double> times, samples;  ///< dots; none where empty
  std::span<const double> residuals;       ///< samples less curve, in a strip of their own; none where empty
  std::function<double(double)> value;     ///< of the curve
  std::vector<CurveKey> keys;
  bool has_slopes = false;  ///< keys have handles for their slopes
  PlotRange range;          ///< of x
  double now = 0.0;         ///< what is shown in the picture
  const char* unit = "s";
  std::string caption;  ///< stands in the plot
};

/// What the user did on it, at most one thing a frame.
struct PlotAction {
  enum class Kind { none, set_value, set_slope, add, remove, released } kind = Kind::none;
  std::size_t key = 0;
  double x = 0.0, value = 0.0;  ///< where the pointer is; of a key: where it goes
  bool in_time = false;         ///< the key goes to another time, too
  double slope = 0.0;
};

/// Fills the room that is left. The panel keeps what is dragged, and the part that the wheel has zoomed to.
PlotAction draw_plot(const PlottedCurve& curve, MotionPanel& panel);

}  // namespace sinew
