#pragma once
/// Legendre's polynomials on -1..1, in which every segment of a fitted curve is written: orthogonal there, so that no
/// degree used here is ill-conditioned.

#include <array>
#include <span>

namespace sinew {

constexpr int max_degree = 8;  ///< of a segment
constexpr int max_coefficients = max_degree + 1;

using LegendreValues = std::array<double, max_coefficients>;

/// P_0(x) to P_8(x) by Bonnet's recurrence, (k + 1) P_(k+1) = (2k + 1) x P_k - k P_(k-1).
LegendreValues legendre_values(double x);

/// The sum of coefficients[k] P_k(x); at most max_coefficients of them.
double legendre_sum(std::span<const double> coefficients, double x);

/// Coefficients of the derivative of that sum by x: d_k = (2k + 1) (c_(k+1) + c_(k+3) + ...).
LegendreValues legendre_derivative(std::span<const double> coefficients);

/// The integral over -1..1 of the square of that sum: the sum of 2 c_k^2 / (2k + 1).
double legendre_square_integral(std::span<const double> coefficients);

}  // namespace sinew
