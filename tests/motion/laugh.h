#pragma once
/// A made-up laugh: the neck's rotation about x, thrown back, shaking, and returning.

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "engine/core/math.h"

namespace sinew::test {

/// Degrees at a time from 0 to 4 seconds.
inline double laugh_angle(double t) {
  const double window = smoothstep01((t - 0.8) / 0.3) * smoothstep01((3.2 - t) / 0.3);
  return -25.0 * smoothstep01(t / 0.8) + 4.0 * std::sin(2.0 * std::numbers::pi * 2.5 * t) * window +
         20.0 * smoothstep01((t - 3.2) / 0.6);
}

struct NoisyLaugh {
  std::vector<double> times, clean, noisy;  ///< [120]

  explicit NoisyLaugh(unsigned seed, double sigma = 1.0) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> noise(0.0, sigma);
    for (int i = 0; i < 120; ++i) {
      times.push_back(i * 4.0 / 119.0);
      clean.push_back(laugh_angle(times.back()));
      noisy.push_back(clean.back() + noise(generator));
    }
  }
};

/// The root mean square of the differences of two rows of one length.
inline double rms_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(squares / static_cast<double>(a.size()));
}

}  // namespace sinew::test
