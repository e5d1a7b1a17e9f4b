#include "engine/motion/segment_tables.h"

#include <algorithm>

#include <Eigen/Cholesky>

namespace sinew {
namespace {

/// A ten millionth of what one sample weighs against the curvature of a segment from it to the next: enough to decide
/// where samples do not.
constexpr double curvature_weight = 1e-7;

}  // namespace

SegmentTable::SegmentTable(std::size_t steps) : basis(steps + 1) {
  const auto length = static_cast<double>(steps);
  highest_degree =
      std::clamp(static_cast<int>(std::min<std::size_t>(steps, max_degree)), lowest_smooth_degree, max_degree);
  const int bubbles = highest_degree - lowest_smooth_degree;
  legendre = smooth_basis(max_degree, length, 1.0);
  SegmentMatrix gram = curvature_weight * 8.0 / (length * length * length) * legendre.transpose() *
                       curvature_integrals(max_degree) * legendre;
  std::vector<SegmentVector> rows;
  for (std::size_t i = 0; i <= steps; ++i) {
    const LegendreValues p = legendre_values(2.0 * static_cast<double>(i) / length - 1.0);
    rows.push_back(legendre.transpose() * Eigen::Map<const Eigen::Vector<double, max_coefficients>>(p.data()));
    if (i < steps) gram.noalias() += rows.back() * rows.back().transpose();
  }
  SegmentMatrix change = SegmentMatrix::Identity(max_coefficients, max_coefficients);
  change.bottomRightCorner<most_bubbles, most_bubbles>().setZero();
  if (bubbles > 0) {
    const Eigen::LLT<SegmentMatrix> factor(gram.block(end_unknowns, end_unknowns, bubbles, bubbles));
    SegmentMatrix inverse = SegmentMatrix::Identity(bubbles, bubbles);
    factor.matrixU().solveInPlace(inverse);
    change.block(end_unknowns, end_unknowns, bubbles, bubbles) = inverse;
  }
  legendre = (legendre * change).eval();
  gram = (change.transpose() * gram * change).eval();
  for (std::size_t i = 0; i <= steps; ++i) {
    const SegmentVector values = change.transpose() * rows[i];
    std::copy(values.begin(), values.end(), basis[i].begin());
  }
  ends[0] = gram.topLeftCorner<4, 4>();
  for (int k = 0; k < most_bubbles; ++k) {
    coupling[k] = gram.block<4, 1>(0, end_unknowns + k);
    ends[k + 1] = ends[k] - coupling[k] * coupling[k].transpose();
  }
}

const SegmentTable& SegmentTables::of(std::size_t steps) {
  std::call_once(made_[steps], [&] { tables_[steps] = std::make_unique<const SegmentTable>(steps); });
  return *tables_[steps];
}

}  // namespace sinew
