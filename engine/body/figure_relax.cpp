#include "engine/body/figure_relax.h"

#include <algorithm>

#include "engine/body/figure_untangle.h"
#include "engine/core/parallel.h"

namespace sinew {
namespace {

constexpr int cage_rounds = 30, surface_rounds = 5;

/// Share of the step to the neighbours' mean that is taken along the normal: little, so that hollows stay hollow.
constexpr double kept_of_normal = 0.25;

/// Share of the way back to its station that an anchored vertex goes each round.
constexpr double anchor_pull = 0.6;

/// Smoothing that does not shrink, for what is finer than the measures are (Taubin 1995).
constexpr double taubin_steps[] = {0.4, -0.41, 0.4, -0.41};

/// Of a mesh with this many quads a half and more the edges are finer than the measures' grid.
constexpr std::size_t fine_quads = 12000;

Vec3 mean_of(const std::vector<Vec3>& positions, std::span<const Index> neighbours) {
  Vec3 sum(0.0);
  for (const Index n : neighbours) sum += positions[n];
  return sum / static_cast<double>(neighbours.size());
}

/// One step of all vertices towards the surface; `normals` are those where they were.
void project(std::vector<Vec3>& positions, std::vector<Vec3>& normals, const std::vector<char>& on_plane,
             const BodyField& field) {
  parallel_for(
      positions.size(),
      [&](std::size_t i) {
        normals[i] = field.step_to_surface(positions[i]);
        if (on_plane[i]) positions[i].x = 0.0;
      },
      256);
}

}  // namespace

Neighbours::Neighbours(const Quads& quads, std::size_t vertices) {
  std::vector<CageEdge> edges;
  edges.reserve(quads.size() * 4);
  for (const auto& quad : quads)
    for (std::size_t c = 0; c < 4; ++c) edges.push_back(cage_edge(quad[c], quad[(c + 1) % 4]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  first.assign(vertices + 1, 0);
  for (const auto& [a, b] : edges) ++first[a + 1], ++first[b + 1];
  for (std::size_t i = 0; i < vertices; ++i) first[i + 1] += first[i];
  entries.resize(edges.size() * 2);
  std::vector<Index> next(first.begin(), first.end() - 1);
  for (const auto& [a, b] : edges) {
    entries[next[a]++] = b;
    entries[next[b]++] = a;
  }
}

void relax_cage(HalfCage& cage, const BodyField& field) {
  const std::size_t count = cage.vertices.size();
  const Neighbours neighbours(cage.quads, count);
  std::vector<Vec3> positions, normals(count);
  std::vector<char> on_plane;
  for (const CageVertex& v : cage.vertices) {
    positions.push_back(v.position);
    on_plane.push_back(v.on_plane);
  }
  for (int i = 0; i < 2; ++i) project(positions, normals, on_plane, field);
  for (int round = 0; round < cage_rounds; ++round) {
    const std::vector<Vec3> before = positions;
    for (std::size_t i = 0; i < count; ++i) {
      const CageVertex& v = cage.vertices[i];
      Vec3 step = mean_of(before, neighbours.of(i)) - before[i];
      step -= (1.0 - kept_of_normal) * glm::dot(step, normals[i]) * normals[i];
      positions[i] += v.looseness * step;
      if (v.anchored) positions[i] += anchor_pull * (v.station - glm::dot(v.axis, positions[i])) * v.axis;
      if (v.on_plane) positions[i].x = 0.0;
    }
    project(positions, normals, on_plane, field);
  }
  project(positions, normals, on_plane, field);
  for (std::size_t i = 0; i < count; ++i) cage.vertices[i].position = positions[i];
}

void settle_surface(HalfSurface& surface, const BodyField& field) {
  const std::size_t count = surface.positions.size();
  const Neighbours neighbours(surface.quads, count);
  std::vector<Vec3> normals(count), before;
  for (int i = 0; i < 2; ++i) project(surface.positions, normals, surface.on_plane, field);
  for (int round = 0; round < surface_rounds; ++round) {
    before = surface.positions;
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 step = mean_of(before, neighbours.of(i)) - before[i];
      step -= (1.0 - kept_of_normal) * glm::dot(step, normals[i]) * normals[i];
      surface.positions[i] += surface.looseness[i] * step;
      if (surface.on_plane[i]) surface.positions[i].x = 0.0;
    }
    project(surface.positions, normals, surface.on_plane, field);
  }
  for (const double share : taubin_steps) {
    if (surface.quads.size() < fine_quads) break;
    before = surface.positions;
    for (std::size_t i = 0; i < count; ++i) {
      surface.positions[i] += share * (mean_of(before, neighbours.of(i)) - before[i]);
      if (surface.on_plane[i]) surface.positions[i].x = 0.0;
    }
  }
  untangle(surface, neighbours);
}

}  // namespace sinew
