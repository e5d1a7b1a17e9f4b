#include "engine/motion/piecewise_polynomial.h"

#include <cmath>

#include <gtest/gtest.h>

namespace sinew {
namespace {

TEST(Legendre, HasItsClosedForms) {
  for (const double x : {-1.0, -0.3, 0.0, 0.7, 1.0}) {
    const LegendreValues p = legendre_values(x);
    EXPECT_NEAR(p[2], 0.5 * (3 * x * x - 1), 1e-15);
    EXPECT_NEAR(p[3], 0.5 * (5 * x * x * x - 3 * x), 1e-15);
    EXPECT_NEAR(p[4], (35 * std::pow(x, 4) - 30 * x * x + 3) / 8.0, 1e-15);
  }
}

TEST(Legendre, DerivativeIsThatOfDifferences) {
  const std::vector<double> c{0.3, -1.0, 2.0, 0.5, -0.7, 0.2, 0.9, -0.4, 0.6};
  const LegendreValues d = legendre_derivative(c);
  for (const double x : {-0.9, -0.2, 0.4, 0.8}) {
    const double h = 1e-5, difference = (legendre_sum(c, x + h) - legendre_sum(c, x - h)) / (2 * h);
    EXPECT_NEAR(legendre_sum(d, x), difference, 1e-6);  // h^2 times a third derivative of some thousands
  }
}

/// 1 + 2t on 0..1, then 3 + 2(t - 1) + (t - 1)^2 on 1..3.
PiecewisePolynomial line_then_parabola() { return {{0, 1, 3}, {{2, 1}, {6 + 1.0 / 3, 4, 2.0 / 3}}}; }

TEST(PiecewisePolynomial, EvaluatesValueAndSlope) {
  const PiecewisePolynomial curve = line_then_parabola();
  EXPECT_NEAR(curve.value(0.5), 2.0, 1e-12);
  EXPECT_NEAR(curve.slope(0.5), 2.0, 1e-12);
  EXPECT_NEAR(curve.value(2.0), 6.0, 1e-12);
  EXPECT_NEAR(curve.slope(2.0), 4.0, 1e-12);
  EXPECT_NEAR(curve.largest_jump().value, 0.0, 1e-12);
  EXPECT_NEAR(curve.largest_jump().slope, 0.0, 1e-12);
}

TEST(PiecewisePolynomial, HoldsItsEnds) {
  const PiecewisePolynomial curve = line_then_parabola();
  EXPECT_NEAR(curve.value(-5.0), 1.0, 1e-12);
  EXPECT_NEAR(curve.value(99.0), 11.0, 1e-12);
  EXPECT_EQ(curve.slope(99.0), 0.0);
  // Three ends with value and slope each, and one cut: lower degrees leave nothing more to say.
  EXPECT_EQ(curve.stored_numbers(), 7u);
}

TEST(PiecewisePolynomial, RefusesWhatIsNoCurve) {
  EXPECT_TRUE(line_then_parabola().validate());
  EXPECT_FALSE((PiecewisePolynomial{{0, 1}, {}}).validate());
  EXPECT_FALSE((PiecewisePolynomial{{0, 0}, {{1}}}).validate());
  EXPECT_FALSE((PiecewisePolynomial{{0, 1, 2}, {{1}}}).validate());
  EXPECT_FALSE((PiecewisePolynomial{{0, 1}, {{NAN}}}).validate());
  EXPECT_FALSE((PiecewisePolynomial{{0, 1}, {std::vector<double>(10, 0.0)}}).validate());
}

}  // namespace
}  // namespace sinew
