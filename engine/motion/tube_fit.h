#pragma once
/// A curve within a tolerance of its samples: the tube about them.

#include <cassert>

#include "engine/motion/segment_chain.h"

namespace sinew {

/// Looks for a curve whose every sample is within the tolerance. From the least squares fit on, samples that miss are
/// projected onto the tube and the corrections onto the curves, again and again, with Pierra's extrapolated steps
/// (*Decomposition through formalization in a product space*, 1984): what is used up is the largest error, where least
/// squares use up the mean one.
class TubeFit {
 public:
  /// `values`: [samples], which must outlive it; `tolerance` > 0, in their unit.
  TubeFit(SegmentTables& tables, std::span<const double> values, double tolerance)
      : values_(values), tolerance_(tolerance), projection_(tables) {
    assert(tolerance > 0.0);
  }

  /// Gives the row such a shape, fixed knots as they are; false, and the shape as it was, where none was found.
  bool hold(SegmentChain& chain, bool fixed_begin, bool fixed_end);
  /// The largest distance of a sample in each segment, [segments], that the last hold() ended with.
  std::vector<double> misses(const SegmentChain& chain) const;

  double tolerance() const { return tolerance_; }
  std::span<const double> values() const { return values_; }

 private:
  struct Excess {
    double squares = 0.0, largest = 0.0;
  };
  void start(const SegmentChain& chain, bool fixed_begin, bool fixed_end);
  Excess collect_excess(std::size_t first);

  std::span<const double> values_;
  double tolerance_;
  ChainProjection projection_;
  ChainShape shape_, step_;
  std::vector<double> fitted_, excess_, moved_;  ///< [samples of the row]
};

}  // namespace sinew
