#include "engine/motion/selected_fit.h"

#include <algorithm>
#include <cmath>

#include "engine/motion/curve_cuts.h"
#include "engine/motion/sample_smoothing.h"
#include "engine/motion/tolerant_fit.h"
#include "engine/motion/wiener_filter.h"

namespace sinew {
namespace {

/// A largest error of this share of the standard error adds next to nothing to it.
constexpr double followed_share = 0.3;

/// Without their noise; what a jump parts is smoothed apart.
SmoothedSamples without_noise(std::span<const double> samples, double resolution) {
  SmoothedSamples all;
  double squares = 0.0;
  std::vector<std::size_t> ends = find_jumps(samples, resolution);
  ends.push_back(samples.size() - 1);
  std::size_t begin = 0;
  for (const std::size_t end : ends) {
    const auto part = samples.subspan(begin, end + 1 - begin);
    const SmoothedSamples smooth = filter_waves(part, smooth_samples(part, resolution), resolution);
    all.values.insert(all.values.end(), smooth.values.begin(), smooth.values.end());
    all.effective_parameters += smooth.effective_parameters;
    squares += smooth.noise * smooth.noise * static_cast<double>(part.size());
    begin = end + 1;
  }
  all.noise = std::sqrt(squares / static_cast<double>(samples.size()));
  return all;
}

}  // namespace

PiecewisePolynomial fit_selected(SegmentTables& tables, const EvenSamples& samples, int highest_degree,
                                 double resolution) {
  const SmoothedSamples smooth = without_noise(samples.values, resolution);
  const double tolerance = std::max(followed_share * smooth.standard_error(), resolution);
  const EvenSamples smoothed{samples.begin, samples.spacing, smooth.values};
  const PiecewisePolynomial within = fit_within(tables, smoothed, tolerance, highest_degree);
  if (within.segments() == 1) return within;
  // What counts here is the mean error, not the largest.
  Segmentation segmentation;
  for (const double cut : within.cuts)
    segmentation.cuts.push_back(static_cast<std::size_t>(std::llround((cut - samples.begin) / samples.spacing)));
  for (const auto& segment : within.coefficients) segmentation.degrees.push_back(static_cast<int>(segment.size()) - 1);
  return fit_smooth(tables, smoothed, segmentation);
}

std::vector<std::size_t> cuts_for(std::span<const double> values, std::size_t segments, double resolution) {
  std::vector<Extremum> extrema = find_extrema(smooth_samples(values, resolution).values);
  std::stable_sort(extrema.begin(), extrema.end(),
                   [](const Extremum& a, const Extremum& b) { return a.prominence > b.prominence; });
  std::vector<std::size_t> cuts{0, values.size() - 1};
  for (std::size_t i = 0; i < extrema.size() && cuts.size() <= segments; ++i) cuts.push_back(extrema[i].sample);
  std::sort(cuts.begin(), cuts.end());
  while (cuts.size() <= segments) {
    std::size_t widest = 0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      if (cuts[i + 1] - cuts[i] > cuts[widest + 1] - cuts[widest]) widest = i;
    const std::size_t cut = (cuts[widest] + cuts[widest + 1]) / 2;
    if (cut == cuts[widest]) break;
    cuts.insert(cuts.begin() + static_cast<std::ptrdiff_t>(widest) + 1, cut);
  }
  return cuts;
}

}  // namespace sinew
