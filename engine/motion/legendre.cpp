#include "engine/motion/legendre.h"

#include <cassert>

namespace sinew {
namespace {

/// Bonnet's factors: P_(k+1) = ahead[k] x P_k - behind[k] P_(k-1). Divisions are what a sum would take longest for.
constexpr auto factors = [] {
  struct {
    std::array<double, max_coefficients> ahead{}, behind{};
  } f;
  for (int k = 0; k < max_coefficients; ++k) {
    f.ahead[k] = (2.0 * k + 1.0) / (k + 1.0);
    f.behind[k] = k / (k + 1.0);
  }
  return f;
}();

}  // namespace

LegendreValues legendre_values(double x) {
  LegendreValues p{1.0, x};
  for (int k = 1; k < max_degree; ++k) p[k + 1] = factors.ahead[k] * x * p[k] - factors.behind[k] * p[k - 1];
  return p;
}

double legendre_sum(std::span<const double> coefficients, double x) {
  assert(coefficients.size() <= static_cast<std::size_t>(max_coefficients));
  double before = 0.0, now = 1.0, sum = 0.0;
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    sum += coefficients[k] * now;
    const double next = factors.ahead[k] * x * now - factors.behind[k] * before;
    before = now;
    now = next;
  }
  return sum;
}

LegendreValues legendre_derivative(std::span<const double> coefficients) {
  assert(coefficients.size() <= static_cast<std::size_t>(max_coefficients));
  LegendreValues derivative{};
  for (int k = static_cast<int>(coefficients.size()) - 2; k >= 0; --k) {
    const double above = k + 2 < max_coefficients ? derivative[k + 2] / (2 * k + 5) : 0.0;
    derivative[k] = (2 * k + 1) * (coefficients[k + 1] + above);
  }
  return derivative;
}

double legendre_square_integral(std::span<const double> coefficients) {
  double sum = 0.0;
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    sum += 2.0 * coefficients[k] * coefficients[k] / (2.0 * static_cast<double>(k) + 1.0);
  return sum;
}

}  // namespace sinew
