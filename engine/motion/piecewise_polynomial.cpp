#include "engine/motion/piecewise_polynomial.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace sinew {
namespace {

/// The place of a time within a segment, -1 to 1.
double local(const PiecewisePolynomial& curve, std::size_t segment, double seconds) {
  const double from = curve.cuts[segment], to = curve.cuts[segment + 1];
  return (2.0 * seconds - from - to) / (to - from);
}

}  // namespace

int PiecewisePolynomial::degree() const {
  std::size_t most = 1;
  for (const auto& segment : coefficients) most = std::max(most, segment.size());
  return static_cast<int>(most) - 1;
}

std::size_t PiecewisePolynomial::segment_at(double seconds) const {
  assert(!coefficients.empty());
  const auto later = std::upper_bound(cuts.begin() + 1, cuts.end() - 1, seconds);
  return static_cast<std::size_t>(later - cuts.begin()) - 1;
}

double PiecewisePolynomial::value(double seconds) const {
  const double inside = std::clamp(seconds, begin(), end());
  return value_in(segment_at(inside), inside);
}

double PiecewisePolynomial::slope(double seconds) const {
  if (seconds < begin() || seconds > end()) return 0.0;
  return slope_in(segment_at(seconds), seconds);
}

double PiecewisePolynomial::value_in(std::size_t segment, double seconds) const {
  return legendre_sum(coefficients[segment], local(*this, segment, seconds));
}

double PiecewisePolynomial::slope_in(std::size_t segment, double seconds) const {
  const LegendreValues derivative = legendre_derivative(coefficients[segment]);
  return legendre_sum(derivative, local(*this, segment, seconds)) * 2.0 / (cuts[segment + 1] - cuts[segment]);
}

CutJump PiecewisePolynomial::largest_jump() const {
  CutJump jump;
  for (std::size_t i = 1; i < segments(); ++i) {
    jump.value = std::max(jump.value, std::abs(value_in(i, cuts[i]) - value_in(i - 1, cuts[i])));
    jump.slope = std::max(jump.slope, std::abs(slope_in(i, cuts[i]) - slope_in(i - 1, cuts[i])));
  }
  return jump;
}

std::size_t PiecewisePolynomial::stored_numbers() const {
  if (segments() == 1) return coefficients[0].size();
  // Value and slope at every cut and end, the cuts' times, and what each segment has beyond a cubic.
  std::size_t numbers = 2 * cuts.size() + segments() - 1;
  for (const auto& segment : coefficients) numbers += segment.size() > 4 ? segment.size() - 4 : 0;
  return numbers;
}

Result<void> PiecewisePolynomial::validate() const {
  if (coefficients.empty()) return bad_input("a curve has no segments; expected one at least");
  if (cuts.size() != coefficients.size() + 1)
    return bad_input("a curve of {} segments has {} cuts; expected {}", segments(), cuts.size(), segments() + 1);
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    if (!std::isfinite(cuts[i])) return bad_input("cut {} of a curve is no finite number", i);
    if (i > 0 && cuts[i] <= cuts[i - 1]) return bad_input("cut {} of a curve is not later than the one before", i);
  }
  for (std::size_t i = 0; i < segments(); ++i) {
    if (coefficients[i].empty() || coefficients[i].size() > static_cast<std::size_t>(max_coefficients))
      return bad_input("segment {} of a curve has {} coefficients; expected 1 to {}", i, coefficients[i].size(),
                       max_coefficients);
    for (const double c : coefficients[i])
      if (!std::isfinite(c)) return bad_input("segment {} of a curve holds a number that is not finite", i);
  }
  return {};
}

PiecewisePolynomial constant_curve(double begin, double end, double value) { return {{begin, end}, {{value}}}; }

}  // namespace sinew
