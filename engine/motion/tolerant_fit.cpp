#include "engine/motion/tolerant_fit.h"

#include <algorithm>
#include <cmath>

#include "engine/motion/chain_growth.h"

namespace sinew {
namespace {

/// Puts `trial` in place of segments `first` up to but not including `end` where the tube lets it be.
bool exchange(TubeFit& tube, SegmentChain& chain, std::size_t first, std::size_t end, SegmentChain&& trial) {
  if (!tube.hold(trial, first > 0, end < chain.segments.size())) return false;
  chain.replace(first, end, trial);
  return true;
}

/// Makes one segment of two, of no more numbers, its neighbours free to follow.
bool merge(TubeFit& tube, SegmentTables& tables, SegmentChain& chain, std::size_t cut, int highest_degree) {
  const ChainSegment &left = chain.segments[cut - 1], &right = chain.segments[cut];
  const std::size_t steps = left.steps + right.steps;
  if (steps > longest_grown) return false;
  const int degree = std::min({left.degree + right.degree - 1, tables.of(steps).highest_degree, highest_degree});
  const std::size_t first = cut < 2 ? 0 : cut - 2, end = std::min(cut + 2, chain.segments.size());
  SegmentChain trial = chain.part(first, end);
  const auto at = static_cast<std::ptrdiff_t>(cut - 1 - first);
  trial.segments[at] = {left.first, steps, degree};
  trial.segments.erase(trial.segments.begin() + at + 1);
  trial.shape.bubbles.erase(trial.shape.bubbles.begin() + at + 1);
  trial.shape.knots.erase(trial.shape.knots.begin() + at + 1);
  return exchange(tube, chain, first, end, std::move(trial));
}

void take_cuts_away(TubeFit& tube, SegmentTables& tables, SegmentChain& chain, int highest_degree) {
  for (bool merged = true; merged;) {
    merged = false;
    for (std::size_t cut = 1; cut < chain.segments.size();)
      if (merge(tube, tables, chain, cut, highest_degree))
        merged = true;
      else
        ++cut;
  }
}

void take_degrees_away(TubeFit& tube, SegmentChain& chain) {
  for (std::size_t i = 0; i < chain.segments.size(); ++i)
    while (chain.segments[i].degree > lowest_smooth_degree) {
      const std::size_t first = i == 0 ? 0 : i - 1, end = std::min(i + 2, chain.segments.size());
      SegmentChain trial = chain.part(first, end);
      --trial.segments[i - first].degree;
      if (!exchange(tube, chain, first, end, std::move(trial))) break;
    }
}

}  // namespace

PiecewisePolynomial fit_within(SegmentTables& tables, const EvenSamples& samples, double tolerance,
                               int highest_degree) {
  if (auto lone = fit_lone_within(samples, tolerance, highest_degree)) return std::move(*lone);
  TubeFit tube(tables, samples.values, tolerance);
  SegmentChain chain = grow_chain(tube, highest_degree);
  take_cuts_away(tube, tables, chain, highest_degree);
  take_degrees_away(tube, chain);
  return chain.curve(tables, samples.begin, samples.spacing);
}

PiecewisePolynomial fit_degrees_within(SegmentTables& tables, const EvenSamples& samples,
                                       const std::vector<std::size_t>& cuts, double tolerance, int highest_degree) {
  Segmentation segmentation{cuts, std::vector<int>(cuts.size() - 1, lowest_smooth_degree)};
  TubeFit tube(tables, samples.values, tolerance);
  for (bool raised = true; raised;) {
    SegmentChain chain = chain_of(segmentation);
    if (tube.hold(chain, false, false)) {
      take_degrees_away(tube, chain);
      return chain.curve(tables, samples.begin, samples.spacing);
    }
    raised = false;
    const std::vector<double> misses = tube.misses(chain);
    for (std::size_t i = 0; i < misses.size(); ++i) {
      int& degree = segmentation.degrees[i];
      if (misses[i] <= tolerance || degree >= std::min(tables.of(cuts[i + 1] - cuts[i]).highest_degree, highest_degree))
        continue;
      ++degree;
      raised = true;
    }
  }
  return fit_smooth(tables, samples, segmentation);
}

}  // namespace sinew
