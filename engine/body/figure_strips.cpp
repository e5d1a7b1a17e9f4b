#include "engine/body/figure_strips.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>

namespace sinew {
namespace {

/// Strips are cut in proportion to this power of their length: those of fingers and toes stay finer than the trunk's.
constexpr double length_power = 0.25;

/// More parts than this no strip is ever cut into: two million vertices need about forty.
constexpr int most_parts = 400;

std::size_t root_of(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

Strips::Strips(const Quads& quads) {
  std::map<CageEdge, std::size_t> edges;
  for (const auto& quad : quads)
    for (std::size_t c = 0; c < 4; ++c) edges.try_emplace(cage_edge(quad[c], quad[(c + 1) % 4]), 0);
  std::size_t next = 0;
  for (auto& [edge, index] : edges) index = next++;
  std::vector<std::size_t> parent(edges.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  for (const auto& quad : quads)
    for (std::size_t c = 0; c < 2; ++c) {
      const std::size_t one = root_of(parent, edges.at(cage_edge(quad[c], quad[c + 1])));
      const std::size_t other = root_of(parent, edges.at(cage_edge(quad[c + 2], quad[(c + 3) % 4])));
      parent[std::max(one, other)] = std::min(one, other);
    }
  std::map<std::size_t, std::size_t> number;
  for (const auto& [edge, index] : edges) {
    const auto [place, is_new] = number.try_emplace(root_of(parent, index), number.size());
    strip_.emplace_back(edge, place->second);
  }
  count_ = number.size();
}

std::size_t Strips::of(Index a, Index b) const {
  const CageEdge edge = cage_edge(a, b);
  const auto found = std::lower_bound(strip_.begin(), strip_.end(), edge,
                                      [](const auto& entry, const CageEdge& wanted) { return entry.first < wanted; });
  assert(found != strip_.end() && found->first == edge);
  return found->second;
}

std::vector<double> Strips::weighted_lengths(const HalfCage& cage) const {
  std::vector<double> sum(count_, 0.0), edges(count_, 0.0);
  for (const auto& [edge, strip] : strip_) {
    const double detail = 0.5 * (cage.vertices[edge.first].detail + cage.vertices[edge.second].detail);
    sum[strip] += detail * glm::distance(cage.at(edge.first), cage.at(edge.second));
    edges[strip] += 1.0;
  }
  for (std::size_t i = 0; i < count_; ++i) sum[i] /= edges[i];
  return sum;
}

RefinedQuads refine_strips(const Quads& quads, std::span<const Index> welded, const Strips& strips,
                           std::span<const int> parts) {
  RefinedQuads out;
  for (Index v = 0; v < welded.size(); ++v) out.vertices.push_back({{v, v, v, v}, {1.0, 0.0, 0.0, 0.0}});
  std::map<CageEdge, Index> first_on_edge;
  for (const auto& quad : quads) {
    const int across = parts[strips.of(welded[quad[0]], welded[quad[1]])];
    const int along = parts[strips.of(welded[quad[1]], welded[quad[2]])];
    const std::size_t row = static_cast<std::size_t>(across) + 1;
    std::vector<Index> grid(row * (static_cast<std::size_t>(along) + 1));
    const auto at = [&](int i, int j) -> Index& { return grid[static_cast<std::size_t>(j) * row + i]; };
    // Each edge of the quad: from where on the grid, in which direction, how many parts.
    const std::array<std::array<int, 5>, 4> sides{
        {{0, 0, 1, 0, across}, {across, 0, 0, 1, along}, {across, along, -1, 0, across}, {0, along, 0, -1, along}}};
    for (std::size_t c = 0; c < 4; ++c) {
      const Index a = quad[c], b = quad[(c + 1) % 4];
      const auto& [i, j, di, dj, n] = sides[c];
      at(i, j) = a;
      const auto [place, is_new] = first_on_edge.try_emplace(cage_edge(a, b), static_cast<Index>(out.vertices.size()));
      if (is_new)
        for (int s = 1; s < n; ++s) {
          const double f = static_cast<double>(s) / n;
          const auto [low, high] = cage_edge(a, b);
          out.vertices.push_back({{low, high, low, low}, {1.0 - f, f, 0.0, 0.0}});
        }
      for (int s = 1; s < n; ++s)
        at(i + s * di, j + s * dj) = place->second + static_cast<Index>((a < b ? s : n - s) - 1);
    }
    for (int j = 1; j < along; ++j)
      for (int i = 1; i < across; ++i) {
        const double x = static_cast<double>(i) / across, y = static_cast<double>(j) / along;
        at(i, j) = static_cast<Index>(out.vertices.size());
        out.vertices.push_back({quad, {(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y}});
      }
    for (int j = 0; j < along; ++j)
      for (int i = 0; i < across; ++i) out.quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  return out;
}

std::size_t refined_quad_count(const Quads& quads, const Strips& strips, std::span<const int> parts) {
  std::size_t count = 0;
  for (const auto& quad : quads)
    count += static_cast<std::size_t>(parts[strips.of(quad[0], quad[1])]) *
             static_cast<std::size_t>(parts[strips.of(quad[1], quad[2])]);
  return count;
}

std::vector<int> parts_for(const Quads& quads, const Strips& strips, std::span<const double> lengths,
                           std::size_t wanted) {
  // Each quad's two strips, looked up once: counting is asked for often.
  std::vector<std::pair<std::size_t, std::size_t>> crossing;
  for (const auto& quad : quads) crossing.emplace_back(strips.of(quad[0], quad[1]), strips.of(quad[1], quad[2]));
  const auto quads_of = [&](const std::vector<int>& parts) {
    std::size_t count = 0;
    for (const auto& [one, other] : crossing)
      count += static_cast<std::size_t>(parts[one]) * static_cast<std::size_t>(parts[other]);
    return count;
  };
  std::vector<double> need;
  for (const double length : lengths) need.push_back(std::pow(length, length_power));
  const auto at_scale = [&](double scale) {
    std::vector<int> parts;
    for (const double n : need) parts.push_back(std::clamp(static_cast<int>(scale * n), 1, most_parts));
    return parts;
  };
  double low = 0.0, high = most_parts / *std::max_element(need.begin(), need.end());
  for (int round = 0; round < 50; ++round) {
    const double middle = 0.5 * (low + high);
    (quads_of(at_scale(middle)) <= wanted ? low : high) = middle;
  }
  std::vector<int> parts = at_scale(low);
  // What is left goes to the strips one by one, the neediest first, as long as one fits.
  for (bool grown = true; grown;) {
    grown = false;
    std::vector<std::size_t> order(parts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order,
                             [&](std::size_t a, std::size_t b) { return need[a] / parts[a] > need[b] / parts[b]; });
    for (const std::size_t strip : order) {
      ++parts[strip];
      grown = quads_of(parts) <= wanted;
      if (grown) break;
      --parts[strip];
    }
  }
  return parts;
}

}  // namespace sinew
