#pragma once
/// A curve over time in segments, each a polynomial of degree 8 at most: engine/definitions.md 14.

#include <cstddef>
#include <vector>

#include "engine/core/result.h"
#include "engine/motion/legendre.h"

namespace sinew {

/// How far a curve's two sides differ at a cut.
struct CutJump {
  double value = 0.0;
  double slope = 0.0;  ///< a second
};

/// Where the curve is asked for outside its range it holds its end value.
struct PiecewisePolynomial {
  std::vector<double> cuts;                       ///< [segments + 1] seconds, strictly rising; first and last: its ends
  std::vector<std::vector<double>> coefficients;  ///< [segments][degree + 1] of P_k(x), x from -1 to 1 over the segment

  std::size_t segments() const { return coefficients.size(); }
  double begin() const { return cuts.front(); }
  double end() const { return cuts.back(); }
  int degree() const;  ///< the highest of any segment
  /// The segment that holds a time; at a cut the later one; 0 or the last outside the range.
  std::size_t segment_at(double seconds) const;

  double value(double seconds) const;
  double slope(double seconds) const;  ///< first derivative, a second; 0 outside the range

  /// Value and slope within one segment, its ends included.
  double value_in(std::size_t segment, double seconds) const;
  double slope_in(std::size_t segment, double seconds) const;

  /// The largest jumps over all cuts; zeros where there is one segment.
  CutJump largest_jump() const;

  /// What must be kept: value and slope once at every cut and end, what each segment has beyond a cubic, and the times
  /// of the cuts; of one segment its coefficients. The two ends' times are the clip's, not the curve's.
  std::size_t stored_numbers() const;

  /// Fails as bad_input where counts, order, degrees or numbers are wrong: for curves that come from a file.
  Result<void> validate() const;
};

/// The curve that has one value throughout.
PiecewisePolynomial constant_curve(double begin, double end, double value);

}  // namespace sinew
