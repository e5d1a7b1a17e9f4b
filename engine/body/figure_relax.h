#pragma once
/// Laying a figure's mesh on the surface, its vertices evenly spread (engine/definitions.md 11).

#include "engine/body/figure_field.h"
#include "engine/body/figure_strips.h"

namespace sinew {

/// Which vertices each vertex has edges with, one run after another.
struct Neighbours {
  std::vector<Index> first{0};  ///< [vertices + 1]
  std::vector<Index> entries;

  Neighbours(const Quads& quads, std::size_t vertices);
  std::span<const Index> of(std::size_t vertex) const {
    return std::span(entries).subspan(first[vertex], first[vertex + 1] - first[vertex]);
  }
};

/// Relaxes the cage: vertices glide over the surface to even out, rings stay plane.
void relax_cage(HalfCage& cage, const BodyField& field);

/// A refined half of the figure.
struct HalfSurface {
  std::vector<Vec3> positions;
  std::vector<char> on_plane;     ///< [vertices] on the plane of symmetry
  std::vector<double> looseness;  ///< [vertices] as of the cage, 0.5 where refinement made the vertex
  Quads quads;
};

/// Lays the refined surface on the field and evens it out.
void settle_surface(HalfSurface& surface, const BodyField& field);

}  // namespace sinew
