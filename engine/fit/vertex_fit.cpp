#include "engine/fit/vertex_fit.h"

#include <algorithm>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/SVD>

namespace sinew {
namespace {

using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Support::most, Support::most>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, Support::most, 1>;

/// Keeps normal equations solvable where bones moved a vertex alike; far below what the square of a double's rounding
/// lets the equations tell apart.
constexpr double ridge = 1e-14;

/// A bone is worth adding only where the error falls along it: cosine between residual and column.
constexpr double least_slope = 1e-9;

/// A set of bones is exchanged only for one that is better by this share, so that rounding decides nothing.
constexpr double worth_an_exchange = 1e-3;
/// A residual below this share of the places' lengths is rounding: no other bones are looked for.
constexpr double rounding = 1e-11;
constexpr std::size_t most_exchanges = 8;  ///< tried a vertex

}  // namespace

bool Support::has(std::uint32_t b) const {
  return std::find(bone.begin(), bone.begin() + size, b) != bone.begin() + size;
}

VertexFit::VertexFit(const BonePoses& poses)
    : poses_(poses),
      columns_(poses.bones, Eigen::VectorXd(3 * poses.poses)),
      lone_errors_(poses.bones),
      there_(poses.bones),
      tried_(poses.bones),
      differences_(3 * poses.poses, Support::most) {}

void VertexFit::begin(const Vec3& rest, std::span<const Vec3> posed) {
  rest_ = rest;
  posed_ = posed;
  std::fill(there_.begin(), there_.end(), 0);
  double squared = 0.0;
  for (const Vec3& place : posed) squared += glm::dot(place, place);
  negligible_ = rounding * rounding * squared;
}

const Eigen::VectorXd& VertexFit::column(std::uint32_t bone) {
  Eigen::VectorXd& d = columns_[bone];
  if (there_[bone]) return d;
  for (std::size_t k = 0; k < poses_.poses; ++k) {
    const Vec3 off = poses_.at(bone, k).transform_point(rest_) - posed_[k];
    for (int i = 0; i < 3; ++i) d[3 * k + i] = off[i];
  }
  lone_errors_[bone] = d.squaredNorm();
  there_[bone] = 1;
  return d;
}

Eigen::VectorXd VertexFit::residual(const Support& support) {
  Eigen::VectorXd r = Eigen::VectorXd::Zero(3 * poses_.poses);
  for (std::size_t i = 0; i < support.size; ++i) r += support.weight[i] * column(support.bone[i]);
  return r;
}

void VertexFit::compute_error(Support& support) { support.error = residual(support).squaredNorm(); }

/// Least squares over the bones of the support with sum w = 1 alone: the first bone's weight is what the others leave.
void VertexFit::solve_equal(const Support& support, std::array<double, Support::most>& weights) {
  const auto others = static_cast<Eigen::Index>(support.size) - 1;
  weights[0] = 1.0;
  if (others == 0) return;
  const Eigen::VectorXd& base = column(support.bone[0]);
  auto differences = differences_.leftCols(others);
  for (Eigen::Index i = 0; i < others; ++i) differences.col(i) = column(support.bone[i + 1]) - base;
  SmallMatrix normal = differences.transpose() * differences;
  normal.diagonal().array() += ridge * normal.trace() + 1e-300;
  const SmallVector right = -(differences.transpose() * base);
  const SmallVector solved = normal.ldlt().solve(right);
  for (Eigen::Index i = 0; i < others; ++i) weights[i + 1] = solved[i];
  weights[0] = 1.0 - solved.sum();
}

/// From weights that are allowed to the best that are: bones whose weight would turn negative leave on the way.
void VertexFit::settle(Support& support) {
  std::array<double, Support::most> wanted{};
  while (true) {
    solve_equal(support, wanted);
    double step = 1.0;
    std::size_t leaving = support.size;
    for (std::size_t i = 0; i < support.size; ++i) {
      if (wanted[i] > 0.0) continue;
      const double reach = support.weight[i] / std::max(support.weight[i] - wanted[i], 1e-300);
      if (leaving < support.size && reach >= step) continue;
      step = std::min(reach, 1.0);
      leaving = i;
    }
    for (std::size_t i = 0; i < support.size; ++i) support.weight[i] += step * (wanted[i] - support.weight[i]);
    if (leaving == support.size) break;
    support.remove(leaving);
    if (support.size == 1) support.weight[0] = 1.0;
  }
  compute_error(support);
}

Support VertexFit::without(const Support& support, std::size_t i) {
  Support rest = support;
  rest.remove(i);
  double sum = 0.0;
  for (std::size_t k = 0; k < rest.size; ++k) sum += rest.weight[k];
  for (std::size_t k = 0; k < rest.size; ++k)
    rest.weight[k] = sum > 0.0 ? rest.weight[k] / sum : 1.0 / static_cast<double>(rest.size);
  settle(rest);
  return rest;
}

/// The bone outside the support along which the error falls fastest, and how fast: the derivative of half the error for
/// weight that goes there from the others alike.
std::uint32_t VertexFit::steepest(const Support& support, double& slope) {
  const Eigen::VectorXd r = residual(support);
  std::uint32_t best = 0;
  slope = 0.0;
  if (support.error <= negligible_) return best;
  for (std::uint32_t b = 0; b < poses_.bones; ++b) {
    if (tried_[b] || support.has(b)) continue;
    const double along = column(b).dot(r) - support.error;
    if (along >= slope || along > -least_slope * std::sqrt(lone_errors_[b] * support.error)) continue;
    slope = along;
    best = b;
  }
  return best;
}

/// Lawson and Hanson, Solving Least Squares Problems, 1974, chapter 23, with the sum of the weights held at 1.
Support VertexFit::best_over_all() {
  Support support;
  std::uint32_t first = 0;
  for (std::uint32_t b = 0; b < poses_.bones; ++b) {
    column(b);
    if (lone_errors_[b] < lone_errors_[first]) first = b;
  }
  support.add(first, 1.0);
  support.error = lone_errors_[first];
  grow(support, Support::most);
  return support;
}

void VertexFit::grow(Support& support, std::size_t most) {
  std::fill(tried_.begin(), tried_.end(), 0);
  for (std::size_t round = 0; round < 8 * most && support.size < most; ++round) {
    double slope = 0.0;
    const std::uint32_t next = steepest(support, slope);
    if (slope == 0.0) break;
    Support grown = support;
    grown.add(next, 0.0);
    settle(grown);
    // Rounding can send the newcomer away at once; then the next best gets its turn.
    tried_[next] = 1;
    if (!(grown.error < support.error * (1.0 - 1e-9))) continue;
    support = grown;
    std::fill(tried_.begin(), tried_.end(), 0);
  }
}

void VertexFit::exchange(Support& support) {
  std::fill(tried_.begin(), tried_.end(), 0);
  for (std::size_t tries = 0; tries < most_exchanges; ++tries) {
    double slope = 0.0;
    const std::uint32_t next = steepest(support, slope);
    if (slope == 0.0) return;
    Support best = support;
    for (std::size_t i = 0; i < support.size; ++i) {
      Support other = support;
      other.bone[i] = next;
      settle(other);
      if (other.error < best.error) best = other;
    }
    tried_[next] = 1;
    if (!(best.error < support.error * (1.0 - worth_an_exchange))) continue;
    support = best;
    std::fill(tried_.begin(), tried_.end(), 0);
  }
}

void VertexFit::prune(Support& support, double allowance) {
  while (support.size > 1) {
    Support best;
    for (std::size_t i = 0; i < support.size; ++i) {
      const Support fewer = without(support, i);
      if (best.size == 0 || fewer.error < best.error) best = fewer;
    }
    if (best.error - support.error >= allowance) return;
    support = best;
  }
}

Support VertexFit::convex(std::size_t influences) {
  Support support = best_over_all();
  if (support.size <= influences) return support;
  while (support.size > influences) {
    Support best;
    for (std::size_t i = 0; i < support.size; ++i) {
      const Support fewer = without(support, i);
      if (best.size == 0 || fewer.error < best.error) best = fewer;
    }
    support = best;
  }
  exchange(support);
  return support;
}

Support VertexFit::convex_from(Support start, std::size_t influences) {
  settle(start);
  grow(start, influences);
  exchange(start);
  return start;
}

Support VertexFit::paper(std::size_t influences) {
  std::vector<std::uint32_t> bones(poses_.bones);
  std::iota(bones.begin(), bones.end(), 0u);
  for (const std::uint32_t b : bones) column(b);
  const std::size_t count = std::min(influences, bones.size());
  std::partial_sort(bones.begin(), bones.begin() + count, bones.end(), [&](std::uint32_t a, std::uint32_t b) {
    return lone_errors_[a] != lone_errors_[b] ? lone_errors_[a] < lone_errors_[b] : a < b;
  });
  Support support;
  for (std::size_t i = 0; i < count; ++i) support.add(bones[i], 1.0 / static_cast<double>(count));
  if (count > 1) {
    // An orthonormal basis of the directions in which weights change and their sum does not.
    const auto n = static_cast<Eigen::Index>(count);
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(n, n - 1);
    for (Eigen::Index c = 0; c + 1 < n; ++c) {
      basis.col(c).head(c + 1).setConstant(1.0);
      basis(c + 1, c) = -static_cast<double>(c + 1);
      basis.col(c).normalize();
    }
    Eigen::MatrixXd all(3 * poses_.poses, n);
    for (Eigen::Index c = 0; c < n; ++c) all.col(c) = column(bones[c]);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(all * basis, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd change = basis * svd.solve(-residual(support));
    for (Eigen::Index c = 0; c < n; ++c) support.weight[c] += change[c];
  }
  compute_error(support);
  return support;
}

bool VertexFit::undetermined(const Support& support) {
  if (support.size < 2) return false;
  const auto others = static_cast<Eigen::Index>(support.size) - 1;
  const Eigen::VectorXd& base = column(support.bone[0]);
  auto differences = differences_.leftCols(others);
  for (Eigen::Index i = 0; i < others; ++i) differences.col(i) = column(support.bone[i + 1]) - base;
  const SmallMatrix normal = differences.transpose() * differences;
  const Eigen::VectorXd pivots = normal.ldlt().vectorD();
  return pivots.minCoeff() <= 1e-12 * pivots.maxCoeff();
}

}  // namespace sinew
