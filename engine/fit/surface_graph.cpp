#include "engine/fit/surface_graph.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace sinew {
namespace {

/// Numbers connected pieces in the order of their first vertices.
void number_shells(SurfaceGraph& graph, std::size_t vertices) {
  constexpr std::uint32_t none = ~0u;
  graph.shell.assign(vertices, none);
  std::vector<std::uint32_t> pending;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    if (graph.shell[v] != none) continue;
    const auto shell = static_cast<std::uint32_t>(graph.shells++);
    graph.shell[v] = shell;
    pending.push_back(v);
    while (!pending.empty()) {
      const std::uint32_t at = pending.back();
      pending.pop_back();
      for (const std::uint32_t next : graph.of(at)) {
        if (graph.shell[next] != none) continue;
        graph.shell[next] = shell;
        pending.push_back(next);
      }
    }
  }
}

std::vector<std::uint32_t> sorted_by_place(std::span<const Vec3> positions) {
  std::vector<std::uint32_t> by_place(positions.size());
  std::iota(by_place.begin(), by_place.end(), 0u);
  const auto place = [&](std::uint32_t v) {
    const Vec3& p = positions[v];
    return std::tuple(p.x, p.y, p.z, v);
  };
  std::sort(by_place.begin(), by_place.end(), [&](auto a, auto b) { return place(a) < place(b); });
  return by_place;
}

}  // namespace

std::vector<std::uint32_t> same_places(std::span<const Vec3> positions, std::size_t& places) {
  const std::vector<std::uint32_t> by_place = sorted_by_place(positions);
  std::vector<std::uint32_t> first(positions.size()), number(positions.size());
  for (std::size_t i = 0; i < by_place.size(); ++i) {
    const bool same = i > 0 && positions[by_place[i]] == positions[by_place[i - 1]];
    first[by_place[i]] = same ? first[by_place[i - 1]] : by_place[i];
  }
  places = 0;
  for (std::uint32_t v = 0; v < positions.size(); ++v)
    number[v] = first[v] == v ? static_cast<std::uint32_t>(places++) : number[first[v]];
  return number;
}

SurfaceGraph surface_graph(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles, bool over_seams) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    edges.emplace_back(a, b);
    edges.emplace_back(b, a);
  };
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
    for (std::size_t c = 0; c < 3; ++c) join(triangles[i + c], triangles[i + (c + 1) % 3]);
  const std::vector<std::uint32_t> by_place = over_seams ? sorted_by_place(positions) : std::vector<std::uint32_t>{};
  for (std::size_t i = 1; i < by_place.size(); ++i)
    if (positions[by_place[i]] == positions[by_place[i - 1]]) join(by_place[i - 1], by_place[i]);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  SurfaceGraph graph;
  std::size_t at = 0;
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    for (; at < edges.size() && edges[at].first == v; ++at)
      if (edges[at].second != v) graph.neighbours.push_back(edges[at].second);
    graph.first.push_back(static_cast<std::uint32_t>(graph.neighbours.size()));
  }
  number_shells(graph, positions.size());
  return graph;
}

}  // namespace sinew
