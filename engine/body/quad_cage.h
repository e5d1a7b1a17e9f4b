#pragma once
/// A closed mesh of quads that stands for a smooth surface: built coarse, refined by Catmull and Clark's rule.
/// Catmull, Clark: Recursively generated B-spline surfaces on arbitrary topological meshes, 1978.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

struct QuadCage {
  std::vector<Vec3> positions;                      ///< metres
  std::vector<std::array<std::uint32_t, 4>> quads;  ///< counter-clockwise seen from outside

  std::uint32_t add(const Vec3& position);
  /// Closes the band between two rings of equal size; seen from outside, `near` runs counter-clockwise before `far`.
  void bridge(std::span<const std::uint32_t> near, std::span<const std::uint32_t> far);
};

/// Where the vertices come to lie after endless refinement (Halstead, Kass, DeRose 1993, the mask for quads).
std::vector<Vec3> limit_positions(const QuadCage& cage);

/// Moves the vertices so that the limit surface passes near where they were: refinement alone would thin a finger by a
/// sixth. Few `rounds` keep the surface calm; endless ones would interpolate and ripple. Vertices where more than four
/// quads meet stay: pulled through such a place the surface would crease.
void aim_limit_at_vertices(QuadCage& cage, int rounds);

/// One step of Catmull-Clark refinement of a closed cage: vertices stay first, in their order; V' = V + E + F.
QuadCage refine(const QuadCage& cage);

/// [vertices] unit normals, the quads' corners weighted by their angle, so that long quads do not tilt them.
std::vector<Vec3> vertex_normals(const QuadCage& cage);

/// Two triangles a quad, cut along the shorter diagonal; three indices each.
std::vector<std::uint32_t> triangles(const QuadCage& cage);

}  // namespace sinew
