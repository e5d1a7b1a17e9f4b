#include "engine/face/seam_weld.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "engine/fit/surface_graph.h"

namespace sinew {
namespace {

/// A triangle's edge that no other triangle has, as that triangle runs.
struct BorderEdge {
  std::uint32_t from, to;
  Vec3 normal;  ///< of its triangle
};

std::vector<BorderEdge> border_edges(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles) {
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::size_t>> edges;  // lower and higher vertex, corner
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [a, b] = std::minmax(triangles[i + c], triangles[i + (c + 1) % 3]);
      edges.emplace_back(a, b, i + c);
    }
  std::ranges::sort(edges);
  const auto same = [&](std::size_t i, std::size_t j) {
    return std::get<0>(edges[i]) == std::get<0>(edges[j]) && std::get<1>(edges[i]) == std::get<1>(edges[j]);
  };
  std::vector<BorderEdge> out;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    for (end = i + 1; end < edges.size() && same(i, end);) ++end;
    if (end > i + 1) continue;
    const std::size_t corner = std::get<2>(edges[i]), first = corner - corner % 3;
    const auto at = [&](std::size_t c) { return triangles[first + c % 3]; };
    const Vec3 normal = glm::cross(positions[at(1)] - positions[at(0)], positions[at(2)] - positions[at(0)]);
    out.push_back({at(corner % 3), at(corner % 3 + 1), unit_or(normal, Vec3(0.0))});
  }
  return out;
}

class Joined {
 public:
  explicit Joined(std::size_t count) : up_(count) { std::iota(up_.begin(), up_.end(), 0u); }
  std::uint32_t root(std::uint32_t v) {
    while (up_[v] != v) v = up_[v] = up_[up_[v]];
    return v;
  }
  /// The lowest number is the root.
  void join(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    up_[high] = low;
  }

 private:
  std::vector<std::uint32_t> up_;
};

}  // namespace

std::vector<std::uint32_t> weld_seams(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles,
                                      std::size_t& places) {
  constexpr double alike = -0.2;  // hard edges of seams turn less
  std::size_t distinct = 0;
  const std::vector<std::uint32_t> place = same_places(positions, distinct);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<BorderEdge>> at;
  for (const BorderEdge& edge : border_edges(positions, triangles))
    at[std::minmax(place[edge.from], place[edge.to])].push_back(edge);

  // Edges that may be one, those of plain seams first: where more borders meet, these tell which belong together.
  struct Pair {
    const BorderEdge *there, *back;
    double facing;
    bool plain;
  };
  std::vector<Pair> pairs;
  for (const auto& [ends, edges] : at)
    for (const BorderEdge& there : edges)
      for (const BorderEdge& back : edges)
        if (place[there.from] == ends.first && place[back.to] == ends.first && ends.first != ends.second)
          if (const double facing = glm::dot(there.normal, back.normal); facing > alike)
            pairs.push_back({&there, &back, facing, edges.size() == 2});
  std::ranges::stable_sort(pairs, std::greater<>(), [](const Pair& p) { return std::pair(p.plain, p.facing); });

  Joined joined(positions.size());
  std::set<const BorderEdge*> used;
  const auto open = [&](const Pair& p) { return !used.contains(p.there) && !used.contains(p.back); };
  const auto join = [&](const Pair& p) {
    used.insert({p.there, p.back});
    joined.join(p.there->from, p.back->to);
    joined.join(p.there->to, p.back->from);
  };
  const auto touch = [&](const Pair& p) {
    return joined.root(p.there->from) == joined.root(p.back->to) ||
           joined.root(p.there->to) == joined.root(p.back->from);
  };
  for (const Pair& p : pairs)
    if (p.plain) join(p);
  for (bool more = true; more;) {
    more = false;
    for (const Pair& p : pairs)
      if (open(p) && touch(p)) join(p), more = true;
  }
  for (const Pair& p : pairs)
    if (open(p)) join(p);
  places = 0;
  std::vector<std::uint32_t> out(positions.size());
  for (std::uint32_t v = 0; v < out.size(); ++v)
    out[v] = joined.root(v) == v ? std::uint32_t(places++) : out[joined.root(v)];
  return out;
}

}  // namespace sinew
