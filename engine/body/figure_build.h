#pragma once
/// A figure together with what it was made from, for those who build on it.

#include "engine/body/figure.h"
#include "engine/body/figure_measures.h"

namespace sinew {

/// From the measures' unit to metres and back: soles at y = 0.
struct FigureScale {
  double scale = 1.0;  ///< metres a unit
  double low = 0.0;    ///< units

  Vec3 to_metres(const Vec3& p) const { return {scale * p.x, scale * (p.y - low), scale * p.z}; }
  Vec3 to_units(const Vec3& p) const { return {p.x / scale, p.y / scale + low, p.z / scale}; }
};

struct BuiltFigure {
  MeasuredBody body;
  FigureScale scale;
  Model model;
};

/// As build_figure; `options` checked.
BuiltFigure built_figure(const BodyOptions& options);

}  // namespace sinew
