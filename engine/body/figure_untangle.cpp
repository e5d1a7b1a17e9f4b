#include "engine/body/figure_untangle.h"

#include <algorithm>

namespace sinew {
namespace {

constexpr int most_rounds = 80;

/// After so many rounds without success the vertices round about move along, and after so many more those beyond them.
constexpr int rounds_alone = 30;

/// Two quads beside each other are folded where their normals' cosine is less: a groove may be steep, not closed.
constexpr double sharpest = -0.35;

/// A quad is folded in itself where a corner's triangle faces away from the quad, or is this small a share of it.
constexpr double least_corner = 0.02;

/// A triangle must face the way its corners' normals do: the cosine, times their three lengths.
constexpr double least_facing = 0.15;

/// Edges inside the half, each with the quads on both sides.
std::vector<std::pair<Index, Index>> quads_beside(const Quads& quads) {
  std::vector<std::pair<CageEdge, Index>> sides;
  for (Index q = 0; q < quads.size(); ++q)
    for (std::size_t c = 0; c < 4; ++c) sides.emplace_back(cage_edge(quads[q][c], quads[q][(c + 1) % 4]), q);
  std::sort(sides.begin(), sides.end());
  std::vector<std::pair<Index, Index>> beside;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
    if (sides[i].first == sides[i + 1].first) beside.emplace_back(sides[i].second, sides[i + 1].second);
  return beside;
}

/// Twice the area of the triangle at a corner, as a vector along its normal.
Vec3 corner_normal(const std::array<Index, 4>& quad, std::size_t corner, const std::vector<Vec3>& positions) {
  const Vec3& here = positions[quad[corner]];
  return glm::cross(positions[quad[(corner + 1) % 4]] - here, positions[quad[(corner + 3) % 4]] - here);
}

}  // namespace

std::size_t untangle(HalfSurface& surface, const Neighbours& neighbours) {
  const auto beside = quads_beside(surface.quads);
  std::vector<Vec3>& positions = surface.positions;
  std::vector<Vec3> normals(surface.quads.size()), at_vertex(positions.size());
  std::vector<char> folded(surface.quads.size()), moving(positions.size());
  std::size_t count = 0;
  for (int round = 0; round <= most_rounds; ++round) {
    std::fill(folded.begin(), folded.end(), char{0});
    for (std::size_t q = 0; q < surface.quads.size(); ++q) {
      const auto& quad = surface.quads[q];
      const Vec3 whole = glm::cross(positions[quad[2]] - positions[quad[0]], positions[quad[3]] - positions[quad[1]]);
      normals[q] = unit_or(whole, Vec3(0.0));
      for (std::size_t c = 0; c < 4; ++c)
        if (glm::dot(corner_normal(quad, c, positions), normals[q]) <= least_corner * glm::length(whole)) folded[q] = 1;
    }
    std::fill(at_vertex.begin(), at_vertex.end(), Vec3(0.0));
    for (std::size_t q = 0; q < surface.quads.size(); ++q)
      for (const Index v : surface.quads[q]) at_vertex[v] += normals[q];
    for (std::size_t q = 0; q < surface.quads.size(); ++q) {
      const auto& quad = surface.quads[q];
      for (std::size_t c = 0; c < 4; ++c) {
        const Vec3 outward = unit_or(at_vertex[quad[c]], Vec3(0.0)) + unit_or(at_vertex[quad[(c + 1) % 4]], Vec3(0.0)) +
                             unit_or(at_vertex[quad[(c + 3) % 4]], Vec3(0.0));
        const Vec3 corner = corner_normal(quad, c, positions);
        if (glm::dot(corner, outward) <= least_facing * glm::length(corner)) folded[q] = 1;
      }
    }
    for (const auto& [one, other] : beside)
      if (glm::dot(normals[one], normals[other]) < sharpest) folded[one] = folded[other] = 1;
    count = static_cast<std::size_t>(std::count(folded.begin(), folded.end(), char{1}));
    if (count == 0 || round == most_rounds) break;

    std::fill(moving.begin(), moving.end(), char{0});
    for (std::size_t q = 0; q < surface.quads.size(); ++q)
      if (folded[q])
        for (const Index v : surface.quads[q]) moving[v] = 1;
    for (int wider = rounds_alone; wider <= round; wider += rounds_alone) {
      const std::vector<char> inner = moving;
      for (std::size_t v = 0; v < positions.size(); ++v)
        if (inner[v])
          for (const Index n : neighbours.of(v)) moving[n] = 1;
    }
    const std::vector<Vec3> before = positions;
    for (std::size_t v = 0; v < positions.size(); ++v) {
      if (!moving[v]) continue;
      Vec3 sum(0.0);
      for (const Index n : neighbours.of(v)) sum += before[n];
      positions[v] = 0.5 * (before[v] + sum / static_cast<double>(neighbours.of(v).size()));
      if (surface.on_plane[v]) positions[v].x = 0.0;
    }
  }
  return count;
}

}  // namespace sinew
