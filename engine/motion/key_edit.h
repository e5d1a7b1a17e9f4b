#pragma once
/// A curve's keys: the value and slope at each cut, and how they are changed without touching what lies further away.

#include <optional>

#include "engine/core/result.h"
#include "engine/motion/piecewise_polynomial.h"

namespace sinew {

struct CurveKey {
  double seconds = 0.0, value = 0.0, slope = 0.0;
};

/// The keys, ends included, [segments + 1].
std::vector<CurveKey> curve_keys(const PiecewisePolynomial& curve);

/// The key within `reach` seconds of a time. Fails as bad_input with the times that there are.
Result<std::size_t> find_key(const PiecewisePolynomial& curve, double seconds, double reach);

/// Gives a key another value and, where given, slope: the segments beside it are changed by the cubic that is 0, with
/// its slope, at their other ends.
void set_key(PiecewisePolynomial& curve, std::size_t key, double value, std::optional<double> slope);

/// Cuts a segment in two of the same degree, the curve as it was; the new key. `seconds` is within the range.
std::size_t add_key(PiecewisePolynomial& curve, double seconds);

/// The two segments beside an inner key become one: the polynomial of the higher degree nearest to both that keeps
/// value and slope at the outer ends.
void delete_key(PiecewisePolynomial& curve, std::size_t key);

/// Moves an inner key to a time between its neighbours: the segments beside it are stretched.
void move_key(PiecewisePolynomial& curve, std::size_t key, double seconds);

/// The part of the curve between two times, moved by `shift` seconds. Where it is constant outside its range, so is
/// this.
PiecewisePolynomial part_of(const PiecewisePolynomial& curve, double from, double to, double shift);

}  // namespace sinew
