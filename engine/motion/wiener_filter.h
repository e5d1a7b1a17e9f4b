#pragma once
/// Smoothed samples brought nearer to the clean ones by what their own spectrum shows.

#include "engine/motion/sample_smoothing.h"

namespace sinew {

/// The empirical Wiener filter (Ghael, Sayeed and Baraniuk 1997, *Improved wavelet denoising via empirical Wiener
/// filtering*) on short-time Fourier transforms: in each of the overlapping windows a wave of power B in the smoothed
/// samples is kept by B / (B + N), N the power of the noise there. A motion that shakes at one pace keeps that pace's
/// waves and loses the noise between them and the slow ones, which no smoothing of a fixed strength can. The row goes
/// on beyond its ends turned about them by half a turn. Two rounds; the second starts from what the first left.
///
/// `smoothed`: what smooth_samples() made of `samples` with the same `resolution`, returned as it is where there are
/// under 16 samples, or no noise.
SmoothedSamples filter_waves(std::span<const double> samples, SmoothedSamples smoothed, double resolution);

}  // namespace sinew
