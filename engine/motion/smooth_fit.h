#pragma once
/// The smooth piecewise polynomial nearest to samples, its cuts given: least squares with value and slope continuous.

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "engine/motion/piecewise_polynomial.h"
#include "engine/motion/smooth_basis.h"

namespace sinew {

/// Where a curve is cut and how it bends between. Cuts stand at samples.
struct Segmentation {
  std::vector<std::size_t> cuts;  ///< [segments + 1] sample indices, rising, from 0 to the last sample
  std::vector<int> degrees;       ///< [segments] 3 to 8

  std::size_t segments() const { return degrees.size(); }
  std::size_t stored_numbers() const;  ///< as PiecewisePolynomial::stored_numbers()
};

/// Fits one curve many times; sums over samples are kept from one fit to the next.
class SmoothFitter {
 public:
  /// `times`: [samples >= 2] seconds, strictly rising; `values`: [samples]. Both must outlive it.
  SmoothFitter(std::span<const double> times, std::span<const double> values);

  /// Minimises sum (f(t_i) - y_i)^2 over all such curves. A trace of curvature (integral f''^2) in the sum decides
  /// between curves where samples do not.
  PiecewisePolynomial fit(const Segmentation& segmentation);

  /// The largest distance to the samples that the best polynomial of this degree over these samples alone leaves: what
  /// a smooth fit will hardly better.
  double lone_error(std::size_t first, std::size_t last, int degree);

  /// The best single polynomial over all samples, degree 0 to 8.
  PiecewisePolynomial lone_fit(int degree);

  std::span<const double> times() const { return times_; }
  std::span<const double> values() const { return values_; }
  double spacing() const { return spacing_; }  ///< mean, seconds

 private:
  /// Sums over the samples from `first` up to but not including `last`, or including it where it is the curve's end.
  struct Sums {
    SegmentMatrix gram;    ///< of P_i P_j, highest degree
    SegmentVector moment;  ///< of P_i y
  };
  const Sums& sums(std::size_t first, std::size_t last);
  SegmentVector lone_coefficients(std::size_t first, std::size_t last, int degree);

  std::span<const double> times_, values_;
  double spacing_;
  std::unordered_map<std::uint64_t, Sums> sums_;
};

/// Distances of the samples from the curve, [samples].
std::vector<double> residuals(const PiecewisePolynomial& curve, std::span<const double> times,
                              std::span<const double> values);

}  // namespace sinew
