#include "engine/face/head_layout.h"

#include <cassert>
#include <map>
#include <set>

#include <Eigen/SparseCholesky>

#include "engine/face/head_cage_parts.h"

namespace sinew {
namespace {

/// Neighbours of the half cage's points; those of a point on the mid line count for both sides.
std::vector<std::set<std::uint32_t>> neighbours(const HeadCage& cage) {
  std::vector<std::set<std::uint32_t>> out(cage.positions.size());
  for (const CageQuad& quad : cage.quads)
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t a = quad.corners[i], b = quad.corners[(i + 1) % 4];
      out[a].insert(b);
      out[b].insert(a);
    }
  return out;
}

constexpr int neck_base = 5, neck_places = 15;

}  // namespace

std::vector<Vec2> skin_layout(const HeadTopology& topology) {
  const HeadCage& cage = topology.cage();
  const auto around = neighbours(cage);
  const auto n = static_cast<Eigen::Index>(around.size());
  const auto on_plane = [&](std::size_t v) { return cage.positions[v].x == 0.0; };
  std::map<std::size_t, Vec2> fixed;
  for (int i = 0; i < neck_places; ++i) {
    const double turn = std::numbers::pi * i / (neck_places - 1);
    fixed[cage.index(neck_point(neck_base, i))] = 0.49 * Vec2(std::sin(turn), std::cos(turn));
  }
  // Half of the head, u from the mid line: a point there has each neighbour off the line twice.
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(n, 2);
  for (std::size_t v = 0; v < around.size(); ++v) {
    const auto row = static_cast<Eigen::Index>(v);
    if (fixed.contains(v)) {
      entries.emplace_back(row, row, 1.0);
      right.row(row) << fixed[v].x, fixed[v].y;
      continue;
    }
    double sum = 0.0;
    for (const std::uint32_t u : around[v]) {
      // The symmetric matrix of the half: an edge inside the line is shared by both halves.
      const double weight = on_plane(v) && on_plane(u) ? 0.5 : 1.0;
      sum += weight;
      if (fixed.contains(u))
        right.row(row) += weight * Eigen::RowVector2d(fixed[u].x, fixed[u].y);
      else
        entries.emplace_back(row, static_cast<Eigen::Index>(u), -weight);
    }
    entries.emplace_back(row, row, sum);
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  assert(solver.info() == Eigen::Success);
  const Eigen::VectorXd v_of = solver.solve(right.col(1));
  // u is 0 on the mid line: those points are fixed as well.
  Eigen::SparseMatrix<double> across = matrix;
  Eigen::VectorXd right_u = right.col(0);
  for (Eigen::Index k = 0; k < across.outerSize(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator it(across, k); it; ++it) {
      const bool row_fixed = on_plane(static_cast<std::size_t>(it.row())),
                 column_fixed = on_plane(static_cast<std::size_t>(it.col()));
      if (row_fixed || column_fixed) it.valueRef() = it.row() == it.col() ? 1.0 : 0.0;
      if (row_fixed) right_u[it.row()] = 0.0;
    }
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_u(across);
  assert(solver_u.info() == Eigen::Success);
  const Eigen::VectorXd u_of = solver_u.solve(right_u);

  CageValues u(around.size()), v(around.size());
  for (std::size_t i = 0; i < u.size(); ++i) {
    u[i] = u_of[static_cast<Eigen::Index>(i)];
    v[i] = v_of[static_cast<Eigen::Index>(i)];
  }
  const std::vector<double> left = topology.left_values(u), even = topology.even_values(v);
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < topology.vertices(); ++i)
    out.emplace_back(0.5 + left[i] - left[topology.mirror()[i]], 0.5 + even[i]);
  return out;
}

}  // namespace sinew
