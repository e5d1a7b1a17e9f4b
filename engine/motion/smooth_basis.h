#pragma once
/// A basis in which value and slope are continuous at every cut by construction: the null space of those constraints,
/// written segment by segment. engine/definitions.md 14.
///
/// A segment's unknowns are value and slope at its two ends (shared with its neighbours: cubic Hermite functions) and,
/// from degree 4 on, bubbles whose value and slope vanish at both ends (Shen 1994, *Efficient spectral-Galerkin method
/// I*, for the biharmonic equation): P_k - 2(2k+5)/(2k+7) P_(k+2) + (2k+3)/(2k+7) P_(k+4).

#include <Eigen/Core>

#include "engine/motion/legendre.h"

namespace sinew {

constexpr int lowest_smooth_degree = 3;  ///< below it two ends leave no choice of value and slope
constexpr int end_unknowns = 4;          ///< value and slope at the begin, value and slope at the end

/// A matrix that never needs more than the highest degree's size, kept on the stack.
using SegmentMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, max_coefficients, max_coefficients>;
using SegmentVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, max_coefficients, 1>;

/// Legendre coefficients of every basis function of a segment, [degree + 1, degree + 1], one a column. A slope's unit
/// is 1 a `slope_unit` seconds; `length` in seconds; degree 3 to 8.
SegmentMatrix smooth_basis(int degree, double length, double slope_unit);

/// The integral of f'' g'' over -1..1 for Legendre's polynomials f and g, [degree + 1, degree + 1].
SegmentMatrix curvature_integrals(int degree);

/// x of matrix x = right, by pivoted LU; the matrix is regular.
SegmentVector solve_square(const SegmentMatrix& matrix, const SegmentVector& right);

}  // namespace sinew
