#pragma once
/// A curve while it is being fitted: segments in a row, joined by knots that both neighbours share, so that value and
/// slope are continuous whatever the numbers are. Time is counted in samples.

#include <span>
#include <vector>

#include "engine/motion/piecewise_polynomial.h"
#include "engine/motion/segment_tables.h"

namespace sinew {

struct ChainSegment {
  std::size_t first = 0, steps = 1;  ///< from sample `first` to sample `first + steps`
  int degree = lowest_smooth_degree;

  std::size_t last() const { return first + steps; }
  int bubbles() const { return degree - lowest_smooth_degree; }
};

/// The numbers that make a curve of a row of segments; a vector space.
struct ChainShape {
  std::vector<Eigen::Vector2d> knots;                     ///< [segments + 1] value, and slope a sample
  std::vector<std::array<double, most_bubbles>> bubbles;  ///< [segments] SegmentTable's, zero beyond the degree

  void clear(std::size_t segments);
  void add(const ChainShape& other, double times);
};

struct SegmentChain {
  std::vector<ChainSegment> segments;
  ChainShape shape;

  std::size_t samples() const { return segments.back().last() - segments.front().first + 1; }
  /// Segments `first` up to but not including `end`, with the knots on both sides.
  SegmentChain part(std::size_t first, std::size_t end) const;
  /// Puts a part in place of segments `first` up to but not including `end`.
  void replace(std::size_t first, std::size_t end, const SegmentChain& part);
  /// Sample i stands at begin + i * spacing seconds.
  PiecewisePolynomial curve(SegmentTables& tables, double begin, double spacing) const;
};

/// Least squares on one row of segments, factorised once.
class ChainProjection {
 public:
  explicit ChainProjection(SegmentTables& tables) : tables_(tables) {}

  /// A fixed knot stays out of it: what project() finds is zero there, with its slope.
  void prepare(std::span<const ChainSegment> segments, bool fixed_begin, bool fixed_end);
  /// The shape nearest to `samples`, [samples of the row].
  void project(std::span<const double> samples, ChainShape& shape);
  /// A shape's values at the samples, [samples of the row].
  void evaluate(const ChainShape& shape, std::span<double> values) const;

 private:
  SegmentTables& tables_;
  std::vector<ChainSegment> segments_;
  std::vector<const SegmentTable*> of_;
  std::vector<Eigen::Matrix2d> pivot_inverse_;  ///< [knots] 0 where a knot is fixed
  std::vector<Eigen::Matrix2d> forward_;        ///< [segments] pivot^-1 times the block to its right
};

}  // namespace sinew
