#pragma once
/// Texture coordinates of figures: the cage cut open along its seams and flattened, chart by chart.

#include <vector>

#include "engine/body/figure_cage.h"
#include "engine/body/figure_strips.h"

namespace sinew {

/// The left half of the cage, cut open: vertices on seams stand once for each side.
struct CutCage {
  std::vector<Index> welded;  ///< [cut vertices] the cage's vertex
  Quads quads;                ///< the cage's, in their order, of cut vertices
  std::vector<Vec2> uv;       ///< [cut vertices] for the left half: u from 0.5 to 1; the right half has 1 - u
};

/// Cuts and flattens the cage, each chart by least squares conformal maps (Levy, Petitjean, Ray, Maillot 2002). Charts
/// that reach the plane of symmetry have it at u = 0.5. All charts have the same scale and none overlaps another.
CutCage cut_cage(const HalfCage& cage);

}  // namespace sinew
