#include "engine/motion/wiener_filter.h"

#include <gtest/gtest.h>

#include "tests/motion/laugh.h"

namespace sinew {
namespace {

using test::NoisyLaugh;
using test::rms_difference;

SmoothedSamples filtered(const std::vector<double>& samples) {
  return filter_waves(samples, smooth_samples(samples, 0.0), 0.0);
}

/// A shake of an even pace under noise of standard deviation 1, at 30 samples a second.
std::vector<double> shake(double hertz, std::size_t samples, unsigned seed, double sigma) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<double> row(samples);
  for (std::size_t i = 0; i < samples; ++i)
    row[i] = 5.0 * std::sin(2.0 * std::numbers::pi * hertz * static_cast<double>(i) / 30.0) + sigma * noise(generator);
  return row;
}

TEST(WienerFilter, BringsAShakeOfAnyPaceNearer) {
  for (const double hertz : {0.7, 1.3, 2.1, 3.4, 5.0}) {
    double smoothed = 0.0, waves = 0.0;
    for (unsigned seed = 1; seed <= 10; ++seed) {
      const auto noisy = shake(hertz, 200, seed, 1.0), clean = shake(hertz, 200, seed, 0.0);
      smoothed += std::pow(rms_difference(smooth_samples(noisy, 0.0).values, clean), 2);
      waves += std::pow(rms_difference(filtered(noisy).values, clean), 2);
    }
    // A lone wave fills two or three of a window's 24, while the smoothing keeps all slower ones besides. A wave near
    // a window's length has nothing beside it to be freed of, and loses a little to the window.
    EXPECT_LT(waves, (hertz > 2.0 ? 0.85 : hertz > 1.0 ? 1.0 : 1.15) * smoothed) << hertz;
  }
}

TEST(WienerFilter, ScalesAndShiftsWithItsSamples) {
  const NoisyLaugh laugh(4);
  const auto plain = filtered(laugh.noisy);
  std::vector<double> other = laugh.noisy;
  for (double& value : other) value = 100.0 - 3.0 * value;
  const auto changed = filtered(other);
  // Rounding alone, of values up to 200.
  for (std::size_t i = 0; i < other.size(); ++i) EXPECT_NEAR(changed.values[i], 100.0 - 3.0 * plain.values[i], 1e-9);
  EXPECT_NEAR(changed.noise, 3.0 * plain.noise, 1e-9);
  EXPECT_NEAR(changed.effective_parameters, plain.effective_parameters, 1e-6);
}

TEST(WienerFilter, ExpectsTheErrorThatItMakes) {
  double expected = 0.0, found = 0.0, parameters = 0.0, before = 0.0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const NoisyLaugh laugh(seed);
    const auto smoothed = smooth_samples(laugh.noisy, 0.0);
    const auto waves = filter_waves(laugh.noisy, smoothed, 0.0);
    expected += std::pow(waves.standard_error(), 2);
    found += std::pow(rms_difference(waves.values, laugh.clean), 2);
    parameters += waves.effective_parameters;
    before += smoothed.effective_parameters;
  }
  // The trace leaves out the bias and the gains' own chance.
  EXPECT_NEAR(std::sqrt(expected / found), 1.0, 0.25);
  EXPECT_LT(parameters, before);
}

TEST(WienerFilter, LeavesWhatHasNoNoiseOrTooFewSamples) {
  const std::vector<double> few{1, 3, 2, 4, 3, 5, 4, 6, 5, 7, 6};
  EXPECT_EQ(filtered(few).values, smooth_samples(few, 0.0).values);
  const std::vector<double> constant(50, 2.5);
  const SmoothedSamples still{constant, 1.0, 0.0};
  EXPECT_EQ(filter_waves(constant, still, 0.0).values, constant);
}

TEST(WienerFilter, TakesRowsOfAnyLength) {
  for (std::size_t samples = 16; samples < 120; ++samples) {
    const auto noisy = shake(2.0, samples, 7, 0.5);
    for (const double value : filtered(noisy).values) ASSERT_TRUE(std::isfinite(value)) << samples;
    EXPECT_LT(rms_difference(filtered(noisy).values, shake(2.0, samples, 7, 0.0)), 0.5) << samples;
  }
}

}  // namespace
}  // namespace sinew
