#pragma once
/// What a mesh has to be before it is a surface: closed polygons, each edge used by at most two, each vertex on at
/// least two edges (Yen 1990, 5.2), wound alike, in one piece.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sinew {

/// Polygons by their corners, any number of three and more.
using Polygons = std::vector<std::vector<std::uint32_t>>;

struct MeshCheck {
  std::size_t open_edges = 0;       ///< used by one polygon
  std::size_t crowded_edges = 0;    ///< used by more than two
  std::size_t misfit_edges = 0;     ///< run through twice in the same direction: polygons wound differently
  std::size_t lonely_vertices = 0;  ///< on fewer than two edges
  std::size_t broken_polygons = 0;  ///< fewer than three corners, or a corner twice
  std::size_t pieces = 0;

  bool sound() const { return crowded_edges + misfit_edges + lonely_vertices + broken_polygons == 0; }
  /// What is wrong, for people; empty where it is sound.
  std::string words() const;
};

MeshCheck check_polygons(std::size_t vertices, const Polygons& polygons);

/// Turns polygons round until neighbours are wound alike. Pieces keep the winding of their first polygon.
void wind_alike(Polygons& polygons);

}  // namespace sinew
