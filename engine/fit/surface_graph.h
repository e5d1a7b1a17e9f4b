#pragma once
/// Which vertices of a mesh touch, over the seams at which a file doubles vertices.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

struct SurfaceGraph {
  std::vector<std::uint32_t> first{0};  ///< [vertices + 1] where each vertex's run starts in `neighbours`
  std::vector<std::uint32_t> neighbours;
  std::vector<std::uint32_t> shell;  ///< [vertices] the connected piece it belongs to, counted by first vertex
  std::size_t shells = 0;

  std::span<const std::uint32_t> of(std::size_t vertex) const {
    return std::span(neighbours).subspan(first[vertex], first[vertex + 1] - first[vertex]);
  }
};

/// Neighbours by the triangles' edges, [3 * triangles] indices; vertices at the very same place are neighbours too,
/// unless `over_seams` is false.
SurfaceGraph surface_graph(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles,
                           bool over_seams = true);

/// Numbers the distinct places, counted in `places`; vertices at the very same place share a number. [vertices]
std::vector<std::uint32_t> same_places(std::span<const Vec3> positions, std::size_t& places);

}  // namespace sinew
