#include "engine/body/figure_charts.h"

#include <algorithm>
#include <map>
#include <numeric>

#include <Eigen/SparseCholesky>

namespace sinew {
namespace {

/// Between charts, and to the picture's edge: a share of the picture.
constexpr double gap = 0.006;

std::size_t root_of(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

/// Calls united(a quad's corner, the other quad's corner at the same vertex) for both ends of every edge that is no
/// seam.
template <class United>
void over_open_edges(const HalfCage& cage, const United& united) {
  std::map<CageEdge, std::pair<std::size_t, std::size_t>> first_side;  // quad, corner where the edge begins
  for (std::size_t q = 0; q < cage.quads.size(); ++q)
    for (std::size_t c = 0; c < 4; ++c) {
      const CageEdge edge = cage_edge(cage.quads[q][c], cage.quads[q][(c + 1) % 4]);
      if (cage.seams.contains(edge)) continue;
      const auto [place, is_new] = first_side.try_emplace(edge, q, c);
      if (is_new) continue;
      // The other side runs against this one: its begin is our end.
      const auto [other, d] = place->second;
      united(4 * q + c, 4 * other + (d + 1) % 4);
      united(4 * q + (c + 1) % 4, 4 * other + d);
    }
}

struct Chart {
  std::vector<Index> vertices;  ///< cut vertices
  Quads quads;                  ///< indices into `vertices`
  std::vector<Vec2> uv;         ///< [vertices] in the measures' unit of length
  bool central = false;
  Vec2 low{0.0}, size{0.0};
};

double area(const Vec3& a, const Vec3& b, const Vec3& c) { return 0.5 * glm::length(glm::cross(b - a, c - a)); }

/// The ends of the chart's line on the plane of symmetry, and its length. Fewer than two points: no line.
struct PlaneLine {
  std::vector<Index> ends;
  double length = 0.0;
};

PlaneLine plane_line(const Chart& chart, const std::vector<Vec3>& positions, const std::vector<char>& on_plane) {
  std::map<CageEdge, int> uses;
  for (const auto& quad : chart.quads)
    for (std::size_t c = 0; c < 4; ++c) ++uses[cage_edge(quad[c], quad[(c + 1) % 4])];
  std::map<Index, int> degree;
  PlaneLine line;
  for (const auto& [edge, count] : uses) {
    if (count != 1 || !on_plane[edge.first] || !on_plane[edge.second]) continue;
    ++degree[edge.first];
    ++degree[edge.second];
    line.length += glm::distance(positions[edge.first], positions[edge.second]);
  }
  for (const auto& [vertex, count] : degree)
    if (count == 1) line.ends.push_back(vertex);
  return line;
}

/// Unknowns of the map: two a vertex, some of them given.
struct Pins {
  std::map<std::size_t, double> value;  ///< by 2 * vertex + (0: u, 1: v)
};

Pins choose_pins(Chart& chart, const std::vector<Vec3>& positions, const std::vector<char>& on_plane) {
  Pins pins;
  const PlaneLine line = plane_line(chart, positions, on_plane);
  chart.central = line.ends.size() == 2;
  if (chart.central) {
    for (std::size_t v = 0; v < positions.size(); ++v)
      if (on_plane[v]) pins.value[2 * v] = 0.0;
    pins.value[2 * line.ends[0] + 1] = 0.0;
    pins.value[2 * line.ends[1] + 1] = line.length;
    return pins;
  }
  std::size_t low = 0, high = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (positions[v].y < positions[low].y) low = v;
    if (positions[v].y > positions[high].y) high = v;
  }
  pins.value = {{2 * low, 0.0},
                {2 * low + 1, 0.0},
                {2 * high, 0.0},
                {2 * high + 1, glm::distance(positions[low], positions[high])}};
  return pins;
}

/// Least squares conformal map: for each triangle, in its own plane, the gradients of u and v are of one length and at
/// right angles.
void flatten(Chart& chart, const std::vector<Vec3>& positions, const std::vector<char>& on_plane) {
  const Pins pins = choose_pins(chart, positions, on_plane);
  std::vector<int> unknown(2 * positions.size(), -1);
  int unknowns = 0;
  for (std::size_t i = 0; i < unknown.size(); ++i)
    if (!pins.value.contains(i)) unknown[i] = unknowns++;

  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> right;
  const auto add = [&](std::size_t variable, double factor) {
    if (factor == 0.0) return;
    if (unknown[variable] >= 0)
      entries.emplace_back(static_cast<int>(right.size()) - 1, unknown[variable], factor);
    else
      right.back() -= factor * pins.value.at(variable);
  };
  for (const auto& quad : chart.quads)
    for (const auto& corners : {std::array{quad[0], quad[1], quad[2]}, std::array{quad[0], quad[2], quad[3]},
                                std::array{quad[1], quad[2], quad[3]}, std::array{quad[1], quad[3], quad[0]}}) {
      const Vec3 &a = positions[corners[0]], &b = positions[corners[1]], &c = positions[corners[2]];
      const double size = area(a, b, c);
      if (size < 1e-14) continue;
      const Vec3 x_axis = glm::normalize(b - a);
      const Vec3 normal = glm::normalize(glm::cross(b - a, c - a)), y_axis = glm::cross(normal, x_axis);
      const std::array<Vec2, 3> flat{Vec2(0.0), Vec2(glm::distance(a, b), 0.0),
                                     Vec2(glm::dot(c - a, x_axis), glm::dot(c - a, y_axis))};
      const double weight = 1.0 / std::sqrt(2.0 * size);
      for (const int part : {0, 1}) {
        right.push_back(0.0);
        for (std::size_t k = 0; k < 3; ++k) {
          const Vec2 w = weight * (flat[(k + 2) % 3] - flat[(k + 1) % 3]);
          add(2 * corners[k], part == 0 ? w.x : w.y);
          add(2 * corners[k] + 1, part == 0 ? -w.y : w.x);
        }
      }
    }
  Eigen::SparseMatrix<double> A(static_cast<int>(right.size()), unknowns);
  A.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(right.data(), static_cast<int>(right.size()));
  const Eigen::SparseMatrix<double> normal_matrix = A.transpose() * A;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(normal_matrix);
  const Eigen::VectorXd solution = solver.solve(A.transpose() * b);
  chart.uv.resize(positions.size());
  for (std::size_t i = 0; i < unknown.size(); ++i)
    chart.uv[i / 2][static_cast<int>(i % 2)] = unknown[i] >= 0 ? solution[unknown[i]] : pins.value.at(i);
}

/// One scale for all charts; the middle ones on the side u >= 0.
void normalise(Chart& chart, const std::vector<Vec3>& positions) {
  double in_space = 0.0, in_plane = 0.0, mean_u = 0.0;
  for (const auto& [a, b, c, d] : chart.quads) {
    in_space += area(positions[a], positions[b], positions[c]) + area(positions[a], positions[c], positions[d]);
    const Vec2 p = chart.uv[c] - chart.uv[a], q = chart.uv[d] - chart.uv[b];
    in_plane += 0.5 * std::abs(p.x * q.y - p.y * q.x);
  }
  for (const Vec2& uv : chart.uv) mean_u += uv.x;
  const double scale = std::sqrt(in_space / in_plane) * (chart.central && mean_u < 0.0 ? -1.0 : 1.0);
  Vec2 high(-INFINITY);
  chart.low = Vec2(INFINITY);
  for (Vec2& uv : chart.uv) {
    uv *= scale;
    chart.low = glm::min(chart.low, uv);
    high = glm::max(high, uv);
  }
  if (chart.central) chart.low.x = std::min(chart.low.x, 0.0);
  chart.size = high - chart.low;
}

/// Central charts above each other along u = 0.5, the others beside them.
void pack(std::vector<Chart>& charts, std::vector<Vec2>& uv) {
  double column_width = 0.0, column_height = 0.0, row_width = 0.0, row_height = 0.0;
  int central = 0, others = 0;
  for (const Chart& chart : charts) {
    if (chart.central) {
      column_width = std::max(column_width, chart.size.x);
      column_height += chart.size.y;
      ++central;
    } else {
      row_width += chart.size.x;
      row_height = std::max(row_height, chart.size.y);
      ++others;
    }
  }
  const double scale = std::min((0.5 - (others + 1) * gap) / (column_width + row_width),
                                std::min((1.0 - (central + 1) * gap) / column_height, (1.0 - 2.0 * gap) / row_height));
  double v = gap, u = 0.5 + scale * column_width + gap;
  for (Chart& chart : charts) {
    const Vec2 corner = chart.central ? Vec2(0.5 + scale * chart.low.x, v) : Vec2(u, gap);
    for (std::size_t i = 0; i < chart.vertices.size(); ++i)
      uv[chart.vertices[i]] = corner + scale * (chart.uv[i] - chart.low);
    if (chart.central)
      v += scale * chart.size.y + gap;
    else
      u += scale * chart.size.x + gap;
  }
}

}  // namespace

CutCage cut_cage(const HalfCage& cage) {
  // Corners of quads that stay together become one cut vertex.
  std::vector<std::size_t> parent(4 * cage.quads.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto unite = [](std::vector<std::size_t>& parents, std::size_t a, std::size_t b) {
    const std::size_t one = root_of(parents, a), other = root_of(parents, b);
    parents[std::max(one, other)] = std::min(one, other);
  };
  std::vector<std::size_t> chart_parent(cage.quads.size());
  std::iota(chart_parent.begin(), chart_parent.end(), std::size_t{0});
  over_open_edges(cage, [&](std::size_t a, std::size_t b) {
    unite(parent, a, b);
    unite(chart_parent, a / 4, b / 4);
  });
  CutCage cut;
  std::map<std::size_t, Index> number;
  for (std::size_t q = 0; q < cage.quads.size(); ++q) {
    cut.quads.emplace_back();
    for (std::size_t c = 0; c < 4; ++c) {
      const auto [place, is_new] = number.try_emplace(root_of(parent, 4 * q + c), static_cast<Index>(number.size()));
      if (is_new) cut.welded.push_back(cage.quads[q][c]);
      cut.quads[q][c] = place->second;
    }
  }
  std::map<std::size_t, Chart> by_root;
  for (std::size_t q = 0; q < cut.quads.size(); ++q) by_root[root_of(chart_parent, q)].quads.push_back(cut.quads[q]);

  cut.uv.resize(cut.welded.size());
  std::vector<Chart> charts;
  for (auto& [root, chart] : by_root) {
    std::map<Index, Index> local;
    for (auto& quad : chart.quads)
      for (Index& corner : quad) {
        const auto [place, is_new] = local.try_emplace(corner, static_cast<Index>(chart.vertices.size()));
        if (is_new) chart.vertices.push_back(corner);
        corner = place->second;
      }
    std::vector<Vec3> positions;
    std::vector<char> on_plane;
    for (const Index v : chart.vertices) {
      positions.push_back(cage.at(cut.welded[v]));
      on_plane.push_back(cage.vertices[cut.welded[v]].on_plane);
    }
    flatten(chart, positions, on_plane);
    normalise(chart, positions);
    charts.push_back(std::move(chart));
  }
  pack(charts, cut.uv);
  return cut;
}

}  // namespace sinew
