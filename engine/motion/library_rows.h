#pragma once
/// Skeletons, samples and curves as a library's columns hold them.

#include <string>

#include "engine/core/files.h"
#include "engine/motion/curve_clip.h"

namespace sinew {

/// The skeleton as JSON: a list of joints, and what the file says of its body.
std::string skeleton_text(const MotionSkeleton& skeleton);
/// Fails as bad_input.
Result<MotionSkeleton> parse_skeleton(const std::string& text);

/// Every frame's root (3), rotations (w, x, y, z each) and, where the motion has them, offsets (3 each): little-endian
/// doubles.
Bytes sample_bytes(const Motion& motion);
/// Fails as bad_input where the bytes do not fit the counts.
Result<std::vector<MotionFrame>> parse_samples(std::span<const unsigned char> bytes, std::size_t frames,
                                               std::size_t joints);

/// Cuts; and of one segment its coefficients, of more, for each, their count, value and slope at its begin and its
/// bubbles (smooth_basis.h, slopes a second), and last the value and slope at the end: little-endian doubles.
Bytes cut_bytes(const PiecewisePolynomial& curve);
Bytes coefficient_bytes(const PiecewisePolynomial& curve);
/// Fails as bad_input.
Result<PiecewisePolynomial> parse_curve(std::span<const unsigned char> cuts,
                                        std::span<const unsigned char> coefficients);

}  // namespace sinew
