#pragma once
/// Diagrams: curves over two axes, with marks and a legend.

#include <string>
#include <vector>

#include "engine/render/text.h"

namespace sinew {

/// An axis from `first` (left, or bottom) to `last`, which may be the smaller, with a line at every multiple of `step`.
struct PlotAxis {
  std::string name;
  double first = 0.0, last = 1.0;
  double step = 0.2;  ///< above 0
};

struct PlotCurve {
  std::string name;          ///< for the legend; empty: it has no entry there
  std::vector<Vec2> points;  ///< in the axes' units; drawn as far as the axes reach
  Colour colour{};
  bool dashed = false;
};

/// A dot with a label, above it at the right or at the left.
struct PlotMark {
  Vec2 at{0.0};
  std::string label;
  Colour colour{};
  bool leftwards = false;
};

struct Plot {
  std::string title;
  PlotAxis x, y;
  std::vector<PlotCurve> curves;
  std::vector<PlotMark> marks;
};

/// A round step, 1, 2 or 5 times a power of ten, that goes into `span` (above 0) about `count` times.
double round_step(double span, int count);

/// The colour of the curve of that index; they repeat after six.
Colour plot_colour(std::size_t index);

/// Letters and lines grow with the picture. Fails as bad_input where an axis is empty or has no step above 0, or where
/// the picture is smaller than 64 pixels a side.
Result<Picture> draw_plot(const Plot& plot, int width, int height, const Font& font);

}  // namespace sinew
