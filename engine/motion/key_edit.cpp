#include "engine/motion/key_edit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/motion/smooth_fit.h"

namespace sinew {
namespace {

/// The segment's polynomial over a part of its time, through its values at Chebyshev's points.
std::vector<double> restricted(const PiecewisePolynomial& curve, std::size_t segment, double from, double to) {
  const int n = static_cast<int>(curve.coefficients[segment].size());
  SegmentMatrix values(n, n);
  SegmentVector right(n);
  for (int i = 0; i < n; ++i) {
    const double x = std::cos((i + 0.5) * std::numbers::pi / n);
    const LegendreValues p = legendre_values(x);
    for (int k = 0; k < n; ++k) values(i, k) = p[k];
    right[i] = curve.value_in(segment, from + 0.5 * (x + 1.0) * (to - from));
  }
  const SegmentVector c = solve_square(values, right);
  return {c.begin(), c.end()};
}

/// Adds the cubic with this value and slope at the begin or end of a segment, and none at its other end.
void add_at_end(PiecewisePolynomial& curve, std::size_t segment, bool at_end, double value, double slope) {
  const double length = curve.cuts[segment + 1] - curve.cuts[segment];
  const SegmentMatrix basis = smooth_basis(lowest_smooth_degree, length, 1.0);
  std::vector<double>& c = curve.coefficients[segment];
  if (c.size() < 4) c.resize(4, 0.0);
  const int column = at_end ? 2 : 0;
  for (int k = 0; k < 4; ++k) c[k] += value * basis(k, column) + slope * basis(k, column + 1);
}

}  // namespace

std::vector<CurveKey> curve_keys(const PiecewisePolynomial& curve) {
  std::vector<CurveKey> keys;
  for (std::size_t i = 0; i < curve.cuts.size(); ++i) {
    const std::size_t segment = std::min(i, curve.segments() - 1);
    keys.push_back({curve.cuts[i], curve.value_in(segment, curve.cuts[i]), curve.slope_in(segment, curve.cuts[i])});
  }
  return keys;
}

Result<std::size_t> find_key(const PiecewisePolynomial& curve, double seconds, double reach) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < curve.cuts.size(); ++i)
    if (std::abs(curve.cuts[i] - seconds) < std::abs(curve.cuts[nearest] - seconds)) nearest = i;
  if (std::abs(curve.cuts[nearest] - seconds) > reach)
    return bad_input("there is no key at {:.4f} s; the nearest is at {:.4f} s", seconds, curve.cuts[nearest]);
  return nearest;
}

void set_key(PiecewisePolynomial& curve, std::size_t key, double value, std::optional<double> slope) {
  const CurveKey now = curve_keys(curve)[key];
  const double up = value - now.value, steeper = slope.value_or(now.slope) - now.slope;
  if (key > 0) add_at_end(curve, key - 1, true, up, steeper);
  if (key < curve.segments()) add_at_end(curve, key, false, up, steeper);
}

std::size_t add_key(PiecewisePolynomial& curve, double seconds) {
  const std::size_t segment = curve.segment_at(seconds);
  const double from = curve.cuts[segment], to = curve.cuts[segment + 1];
  assert(seconds > from && seconds < to);
  auto left = restricted(curve, segment, from, seconds), right = restricted(curve, segment, seconds, to);
  const auto at = static_cast<std::ptrdiff_t>(segment);
  curve.coefficients[segment] = std::move(left);
  curve.coefficients.insert(curve.coefficients.begin() + at + 1, std::move(right));
  curve.cuts.insert(curve.cuts.begin() + at + 1, seconds);
  return segment + 1;
}

void delete_key(PiecewisePolynomial& curve, std::size_t key) {
  assert(key > 0 && key < curve.segments());
  const std::size_t n = std::max({curve.coefficients[key - 1].size(), curve.coefficients[key].size(), std::size_t{4}});
  const double from = curve.cuts[key - 1], to = curve.cuts[key + 1];
  const SegmentMatrix basis = smooth_basis(static_cast<int>(n) - 1, to - from, 1.0);
  SegmentVector unknowns = SegmentVector::Zero(static_cast<Eigen::Index>(n));
  unknowns.head<4>() << curve.value_in(key - 1, from), curve.slope_in(key - 1, from), curve.value_in(key, to),
      curve.slope_in(key, to);
  // The bubbles follow the rest at evenly spaced places.
  const auto inner = static_cast<Eigen::Index>(n) - end_unknowns;
  if (inner > 0) {
    SegmentMatrix gram = SegmentMatrix::Zero(inner, inner);
    SegmentVector moment = SegmentVector::Zero(inner);
    const SegmentVector base = basis * unknowns;
    for (int i = 1; i < 100; ++i) {
      const double x = i / 50.0 - 1.0, t = from + 0.5 * (x + 1.0) * (to - from);
      const LegendreValues p = legendre_values(x);
      const Eigen::Map<const SegmentVector> values(p.data(), static_cast<Eigen::Index>(n));
      const SegmentVector bubbles = basis.rightCols(inner).transpose() * values;
      gram += bubbles * bubbles.transpose();
      moment += bubbles * (curve.value(t) - base.dot(values));
    }
    unknowns.tail(inner) = solve_square(gram, moment);
  }
  const SegmentVector c = basis * unknowns;
  const auto at = static_cast<std::ptrdiff_t>(key);
  curve.coefficients[key - 1].assign(c.begin(), c.end());
  curve.coefficients.erase(curve.coefficients.begin() + at);
  curve.cuts.erase(curve.cuts.begin() + at);
}

void move_key(PiecewisePolynomial& curve, std::size_t key, double seconds) {
  assert(key > 0 && key < curve.segments());
  const std::vector<CurveKey> before = curve_keys(curve);
  curve.cuts[key] = seconds;
  // Stretching changed the slopes on all three sides; each is set back to what it was.
  const auto mend = [&](std::size_t segment, bool at_end, const CurveKey& key_before) {
    const double time = curve.cuts[segment + (at_end ? 1 : 0)];
    add_at_end(curve, segment, at_end, 0.0, key_before.slope - curve.slope_in(segment, time));
  };
  mend(key - 1, false, before[key - 1]);
  mend(key - 1, true, before[key]);
  mend(key, false, before[key]);
  mend(key, true, before[key + 1]);
}

PiecewisePolynomial part_of(const PiecewisePolynomial& curve, double from, double to, double shift) {
  PiecewisePolynomial part;
  part.cuts.push_back(from + shift);
  for (std::size_t i = 0; i < curve.segments(); ++i) {
    const double a = std::max(from, curve.cuts[i]), b = std::min(to, curve.cuts[i + 1]);
    if (b - a <= 1e-9) continue;
    part.coefficients.push_back(restricted(curve, i, a, b));
    part.cuts.push_back(b + shift);
  }
  part.cuts.back() = to + shift;
  return part;
}

}  // namespace sinew
