#include "engine/fit/heat_weights.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include <Eigen/SparseCholesky>

#include "engine/core/interrupt.h"
#include "engine/core/parallel.h"
#include "engine/fit/surface_graph.h"

namespace sinew {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

constexpr double least_share = 1e-5;    ///< of a weight that is kept
constexpr std::size_t together = 8;     ///< bones solved for between two looks for a signal
constexpr double most_cotangent = 1e4;  ///< of slivers

double cotangent(const Vec3& a, const Vec3& b) {
  const double sine = glm::length(glm::cross(a, b));
  return std::clamp(glm::dot(a, b) / std::max(sine, 1e-300), 0.0, most_cotangent);
}

/// Stiffness and areas over places: vertices that coincide are one.
struct Surface {
  std::vector<std::uint32_t> place;  ///< [vertices]
  std::size_t places = 0;
  Matrix laplacian;
  Eigen::VectorXd area;
};

Surface weld(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles) {
  Surface surface;
  surface.place = same_places(positions, surface.places);
  const auto n = static_cast<Eigen::Index>(surface.places);
  surface.area = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(triangles.size() * 4);
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const Vec3 p[3] = {positions[triangles[i]], positions[triangles[i + 1]], positions[triangles[i + 2]]};
    const double area = 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    for (int c = 0; c < 3; ++c) {
      const auto a = static_cast<int>(surface.place[triangles[i + (c + 1) % 3]]);
      const auto b = static_cast<int>(surface.place[triangles[i + (c + 2) % 3]]);
      surface.area[surface.place[triangles[i + c]]] += area / 3.0;
      if (a == b) continue;
      const double half = 0.5 * cotangent(p[(c + 1) % 3] - p[c], p[(c + 2) % 3] - p[c]);
      entries.insert(entries.end(), {{a, a, half}, {b, b, half}, {a, b, -half}, {b, a, -half}});
    }
  }
  surface.laplacian.resize(n, n);
  surface.laplacian.setFromTriplets(entries.begin(), entries.end());
  // Loose vertices have no area; any keeps them at their bone.
  const double least = 1e-9 * std::max(surface.area.maxCoeff(), 1e-300);
  surface.area = surface.area.cwiseMax(least);
  return surface;
}

}  // namespace

Result<std::vector<std::vector<Influence>>> HeatJob::run() const {
  std::vector<std::vector<Influence>> weights(positions.size());
  if (positions.empty()) return weights;
  const Surface surface = weld(positions, triangles);
  Eigen::VectorXd heat(surface.area.size());
  std::vector<std::uint32_t> owner(surface.places);
  for (std::size_t v = positions.size(); v-- > 0;) {
    const std::uint32_t place = surface.place[v];
    heat[place] = surface.area[place] / (distance[v] * distance[v]);
    owner[place] = bone[v];
  }
  Matrix system = surface.laplacian;
  system += Matrix(heat.asDiagonal());
  const Eigen::SimplicialLDLT<Matrix> solver(system);
  if (solver.info() != Eigen::Success) return bad_input("its surface is too degenerate to spread weights over");

  std::vector<char> owns(bones);
  for (const std::uint32_t b : owner) owns[b] = 1;
  std::vector<Eigen::VectorXd> solved(together);
  for (std::uint32_t first = 0; first < bones; first += together) {
    if (auto ok = check(); !ok) return pass_on(std::move(ok));
    const std::size_t count = std::min<std::size_t>(together, bones - first);
    parallel_for(
        count,
        [&](std::size_t i) {
          if (!owns[first + i]) return;
          Eigen::VectorXd source = heat;
          for (std::size_t p = 0; p < surface.places; ++p)
            if (owner[p] != first + i) source[static_cast<Eigen::Index>(p)] = 0.0;
          solved[i] = solver.solve(source);
        },
        1);
    for (std::size_t i = 0; i < count; ++i, advance())
      for (std::size_t v = 0; owns[first + i] && v < positions.size(); ++v)
        if (const double w = solved[i][surface.place[v]]; w > least_share)
          weights[v].push_back({static_cast<std::uint32_t>(first + i), w});
  }
  return weights;
}

}  // namespace sinew
