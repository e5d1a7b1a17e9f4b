#include "engine/face/quad_mesh_check.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>

namespace sinew {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Calls with each edge of the polygon in its direction.
template <class Use>
void for_each_edge(const std::vector<std::uint32_t>& polygon, const Use& use) {
  for (std::size_t i = 0; i < polygon.size(); ++i) use(Edge{polygon[i], polygon[(i + 1) % polygon.size()]});
}

Edge undirected(const Edge& e) { return {std::min(e.first, e.second), std::max(e.first, e.second)}; }

std::size_t root(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

std::string MeshCheck::words() const {
  std::vector<std::string> found;
  if (broken_polygons > 0)
    found.push_back(fmt::format("{} polygons with fewer than three distinct corners", broken_polygons));
  if (crowded_edges > 0) found.push_back(fmt::format("{} edges used by more than two polygons", crowded_edges));
  if (misfit_edges > 0)
    found.push_back(fmt::format("{} edges between polygons that face different ways", misfit_edges));
  if (lonely_vertices > 0) found.push_back(fmt::format("{} vertices on fewer than two edges", lonely_vertices));
  return fmt::format("{}", fmt::join(found, ", "));
}

MeshCheck check_polygons(std::size_t vertices, const Polygons& polygons) {
  MeshCheck out;
  std::map<Edge, int> uses, directed;
  std::vector<std::size_t> edges_at(vertices, 0), piece(vertices);
  std::iota(piece.begin(), piece.end(), std::size_t{0});
  for (const auto& polygon : polygons) {
    const std::set<std::uint32_t> distinct(polygon.begin(), polygon.end());
    if (polygon.size() < 3 || distinct.size() < polygon.size()) ++out.broken_polygons;
    for_each_edge(polygon, [&](const Edge& e) {
      ++uses[undirected(e)];
      ++directed[e];
      piece[root(piece, e.first)] = root(piece, e.second);
    });
  }
  for (const auto& [edge, count] : uses) {
    ++edges_at[edge.first];
    ++edges_at[edge.second];
    out.open_edges += count == 1;
    out.crowded_edges += count > 2;
  }
  for (const auto& [edge, count] : directed) out.misfit_edges += count > 1;
  for (std::size_t v = 0; v < vertices; ++v) {
    out.lonely_vertices += edges_at[v] < 2;
    out.pieces += edges_at[v] > 0 && root(piece, v) == v;
  }
  return out;
}

void wind_alike(Polygons& polygons) {
  std::map<Edge, std::vector<std::size_t>> at_edge;
  for (std::size_t i = 0; i < polygons.size(); ++i)
    for_each_edge(polygons[i], [&](const Edge& e) { at_edge[undirected(e)].push_back(i); });
  std::vector<bool> done(polygons.size(), false);
  for (std::size_t start = 0; start < polygons.size(); ++start) {
    if (done[start]) continue;
    std::vector<std::size_t> open{start};
    done[start] = true;
    while (!open.empty()) {
      const std::vector<std::uint32_t> polygon = polygons[open.back()];
      open.pop_back();
      for_each_edge(polygon, [&](const Edge& edge) {
        for (const std::size_t other : at_edge[undirected(edge)]) {
          if (done[other]) continue;
          done[other] = true;
          open.push_back(other);
          bool same_direction = false;
          for_each_edge(polygons[other], [&](const Edge& e) { same_direction = same_direction || e == edge; });
          if (same_direction) std::reverse(polygons[other].begin(), polygons[other].end());
        }
      });
    }
  }
}

}  // namespace sinew
