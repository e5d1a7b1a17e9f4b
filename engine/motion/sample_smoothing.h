#pragma once
/// Evenly spaced samples without their noise.

#include <span>
#include <vector>

namespace sinew {

struct SmoothedSamples {
  std::vector<double> values;         ///< [samples]
  double effective_parameters = 0.0;  ///< the trace of the hat matrix
  double noise = 0.0;                 ///< estimated standard deviation of one sample's noise

  /// The estimated standard deviation of the smoothed values themselves.
  double standard_error() const;
};

/// Minimises |z - y|^2 + penalty |D z|^2, D the third differences (Whittaker 1923), the penalty by generalised
/// cross-validation (Craven and Wahba 1979) with each parameter counted 1.2 times (Kim and Gu 2004) over waves from two
/// samples to twice the row, at most 250. Linear time in the samples (Hutchinson and de Hoog 1985). Residuals below
/// `resolution` are never worth a parameter. Rows under 8 samples stay as they are.
SmoothedSamples smooth_samples(std::span<const double> samples, double resolution);

/// Samples i after which a row jumps: the step to i + 1 is over ten times as large as the median of the steps up to six
/// samples round it, and as `resolution`. No noise and no fast turn does that: a capture that begins in a pose of its
/// own does, or a cut.
std::vector<std::size_t> find_jumps(std::span<const double> samples, double resolution);

}  // namespace sinew
