#include "engine/motion/tube_fit.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

constexpr int most_steps = 24;
constexpr double hopeless = 4.0;   ///< times the tolerance: what no steps have been seen to mend
constexpr double inside = 0.98;    ///< of the tolerance: aimed at, so that the steps end
constexpr double over = 1.5;       ///< of the extrapolated step; below 2 it converges
constexpr double rounding = 1e-9;  ///< of the tolerance: what the curve's other bases may add

}  // namespace

void TubeFit::start(const SegmentChain& chain, bool fixed_begin, bool fixed_end) {
  const std::size_t samples = chain.samples(), first = chain.segments.front().first;
  fitted_.assign(samples, 0.0);
  moved_.resize(samples);
  excess_.resize(samples);
  projection_.prepare(chain.segments, fixed_begin, fixed_end);
  shape_.clear(chain.segments.size());
  if (fixed_begin) shape_.knots.front() = chain.shape.knots.front();
  if (fixed_end) shape_.knots.back() = chain.shape.knots.back();
  if (fixed_begin || fixed_end) projection_.evaluate(shape_, fitted_);
  for (std::size_t i = 0; i < samples; ++i) excess_[i] = values_[first + i] - fitted_[i];
  projection_.project(excess_, step_);
  shape_.add(step_, 1.0);
  projection_.evaluate(shape_, fitted_);
}

/// How far each sample lies outside the tube.
TubeFit::Excess TubeFit::collect_excess(std::size_t first) {
  Excess excess;
  const double bound = inside * tolerance_;
  for (std::size_t i = 0; i < fitted_.size(); ++i) {
    const double miss = values_[first + i] - fitted_[i];
    excess.largest = std::max(excess.largest, std::abs(miss));
    excess_[i] = miss - std::clamp(miss, -bound, bound);
    excess.squares += excess_[i] * excess_[i];
  }
  return excess;
}

bool TubeFit::hold(SegmentChain& chain, bool fixed_begin, bool fixed_end) {
  const std::size_t first = chain.segments.front().first;
  start(chain, fixed_begin, fixed_end);
  double at_first = 0.0;
  for (int step = 0; step <= most_steps; ++step) {
    const Excess excess = collect_excess(first);
    if (excess.largest <= tolerance_ * (1.0 - rounding)) {
      chain.shape = shape_;
      return true;
    }
    if (step == 0) at_first = excess.squares;
    if (excess.largest > hopeless * tolerance_) return false;
    // Rows that a curve can follow lose most of their excess early.
    if ((step == 8 && excess.squares > 0.5 * at_first) || (step == 16 && excess.squares > 0.15 * at_first))
      return false;
    projection_.project(excess_, step_);
    projection_.evaluate(step_, moved_);
    double squares = 0.0;
    for (const double moved : moved_) squares += moved * moved;
    if (squares <= 1e-12 * excess.squares) return false;
    const double times = over * excess.squares / squares;
    shape_.add(step_, times);
    for (std::size_t i = 0; i < fitted_.size(); ++i) fitted_[i] += times * moved_[i];
  }
  return false;
}

std::vector<double> TubeFit::misses(const SegmentChain& chain) const {
  std::vector<double> largest;
  const std::size_t base = chain.segments.front().first;
  for (const ChainSegment& segment : chain.segments) {
    largest.push_back(0.0);
    for (std::size_t i = segment.first; i <= segment.last(); ++i)
      largest.back() = std::max(largest.back(), std::abs(values_[i] - fitted_[i - base]));
  }
  return largest;
}

}  // namespace sinew
