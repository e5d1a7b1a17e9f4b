#include "engine/motion/smooth_basis.h"

#include <cassert>

#include <Eigen/LU>

namespace sinew {
namespace {

SegmentMatrix all_curvature_integrals() {
  std::array<LegendreValues, max_coefficients> second{};
  for (int k = 0; k < max_coefficients; ++k) {
    LegendreValues one{};
    one[k] = 1.0;
    second[k] = legendre_derivative(legendre_derivative(one));
  }
  SegmentMatrix integrals = SegmentMatrix::Zero(max_coefficients, max_coefficients);
  for (int i = 0; i < max_coefficients; ++i)
    for (int j = 0; j < max_coefficients; ++j)
      for (int k = 0; k < max_coefficients; ++k) integrals(i, j) += second[i][k] * second[j][k] * 2.0 / (2 * k + 1);
  return integrals;
}

/// Hermite's cubics on -1..1, slopes by x, and the bubbles.
SegmentMatrix unit_basis() {
  SegmentMatrix basis = SegmentMatrix::Zero(max_coefficients, max_coefficients);
  basis.topLeftCorner<4, 4>() << 0.5, 1.0 / 6.0, 0.5, -1.0 / 6.0,  //
      -0.6, -0.1, 0.6, -0.1,                                       //
      0.0, -1.0 / 6.0, 0.0, 1.0 / 6.0,                             //
      0.1, 0.1, -0.1, 0.1;
  for (int k = 0; k + 4 < max_coefficients; ++k) {
    basis(k, end_unknowns + k) = 1.0;
    basis(k + 2, end_unknowns + k) = -2.0 * (2 * k + 5) / (2 * k + 7);
    basis(k + 4, end_unknowns + k) = (2.0 * k + 3) / (2 * k + 7);
  }
  return basis;
}

}  // namespace

SegmentMatrix smooth_basis(int degree, double length, double slope_unit) {
  assert(degree >= lowest_smooth_degree && degree <= max_degree);
  static const SegmentMatrix unit = unit_basis();
  SegmentMatrix basis = unit.topLeftCorner(degree + 1, degree + 1);
  const double scale = 0.5 * length / slope_unit;
  basis.col(1) *= scale;
  basis.col(3) *= scale;
  return basis;
}

SegmentMatrix curvature_integrals(int degree) {
  static const SegmentMatrix all = all_curvature_integrals();
  return all.topLeftCorner(degree + 1, degree + 1);
}

SegmentVector solve_square(const SegmentMatrix& matrix, const SegmentVector& right) {
  return matrix.partialPivLu().solve(right);
}

}  // namespace sinew
