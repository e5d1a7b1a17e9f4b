#include "engine/motion/wiener_filter.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <unsupported/Eigen/FFT>

namespace sinew {
namespace {

constexpr std::size_t fewest_samples = 16;
constexpr std::size_t longest_window = 48;  ///< samples: 1.6 s of a film, some cycles of a laugh or a step
constexpr std::size_t hop = 4;              ///< samples from one window's begin to the next one's
constexpr int rounds = 2;

/// A row with `reach` samples more at either end: the row again, turned by half a turn about `first` and `last`.
std::vector<double> turned_about_ends(std::span<const double> row, double first, double last, std::size_t reach) {
  std::vector<double> longer;
  longer.reserve(row.size() + 2 * reach);
  for (std::size_t i = reach; i > 0; --i) longer.push_back(2.0 * first - row[i]);
  longer.insert(longer.end(), row.begin(), row.end());
  for (std::size_t i = 1; i <= reach; ++i) longer.push_back(2.0 * last - row[row.size() - 1 - i]);
  return longer;
}

/// Hann's window, nowhere 0. [size]
std::vector<double> hann_window(std::size_t size) {
  std::vector<double> window(size);
  for (std::size_t i = 0; i < size; ++i)
    window[i] =
        0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(size));
  return window;
}

/// One round. `variance`: of one sample's noise, > 0.
SmoothedSamples filter_once(std::span<const double> samples, const SmoothedSamples& smoothed, double variance) {
  const std::size_t n = samples.size(), size = std::min(longest_window, n - n % 2), reach = size - 1;
  const double first = smoothed.values.front(), last = smoothed.values.back();
  const std::vector<double> rough = turned_about_ends(samples, first, last, reach),
                            clean = turned_about_ends(smoothed.values, first, last, reach), window = hann_window(size);
  double noise = 0.0;  // Parseval: the noise's power in every wave of a window
  for (const double w : window) noise += w * w * variance;

  std::vector<double> sum(rough.size()), weight(rough.size()), kept(rough.size());
  std::vector<double> windowed(size), back(size);
  std::vector<std::complex<double>> waves, clean_waves;
  Eigen::FFT<double> fft;
  for (std::size_t begin = 0; begin + size <= rough.size(); begin += hop) {
    double mean = 0.0;
    for (std::size_t i = 0; i < size; ++i) mean += clean[begin + i] / static_cast<double>(size);
    for (std::size_t i = 0; i < size; ++i) windowed[i] = window[i] * (clean[begin + i] - mean);
    fft.fwd(clean_waves, windowed);
    for (std::size_t i = 0; i < size; ++i) windowed[i] = window[i] * (rough[begin + i] - mean);
    fft.fwd(waves, windowed);
    double share = 0.0;  // of the window's waves that is kept: the diagonal of the filter's matrix
    for (std::size_t k = 0; k < size; ++k) {
      const double power = std::norm(clean_waves[k]), gain = power / (power + noise);
      waves[k] *= gain;
      share += gain / static_cast<double>(size);
    }
    fft.inv(back, waves);
    for (std::size_t i = 0; i < size; ++i) {
      const double square = window[i] * window[i];
      sum[begin + i] += window[i] * back[i] + square * mean;
      weight[begin + i] += square;
      kept[begin + i] += square * share;
    }
  }
  SmoothedSamples filtered{std::vector<double>(n), 0.0, smoothed.noise};
  for (std::size_t i = 0; i < n; ++i) {
    filtered.values[i] = sum[reach + i] / weight[reach + i];
    filtered.effective_parameters += kept[reach + i] / weight[reach + i];
  }
  return filtered;
}

}  // namespace

SmoothedSamples filter_waves(std::span<const double> samples, SmoothedSamples smoothed, double resolution) {
  const double variance = smoothed.noise * smoothed.noise + resolution * resolution;
  if (samples.size() < fewest_samples || variance <= 0.0) return smoothed;
  for (int round = 0; round < rounds; ++round) smoothed = filter_once(samples, smoothed, variance);
  return smoothed;
}

}  // namespace sinew
