#pragma once
/// What a segment of evenly spaced samples is fitted with, which depends on nothing but its length.

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/motion/smooth_basis.h"

namespace sinew {

constexpr int most_bubbles = max_coefficients - end_unknowns;

/// The basis of engine/definitions.md 14 over one segment, time counted in samples: value and slope at both ends, then
/// bubbles, here made orthonormal over the segment's samples (the last left out, which is the next segment's), so that
/// a segment of degree d has the first d - 3 of them and each is a sum by itself.
struct SegmentTable {
  int highest_degree = lowest_smooth_degree;                ///< that its samples can tell apart, 3 to 8
  std::vector<std::array<double, max_coefficients>> basis;  ///< [steps + 1] values of the functions at the samples
  SegmentMatrix legendre;                                   ///< coefficients of P_k of every function, one a column
  std::array<Eigen::Vector4d, most_bubbles> coupling;       ///< sums of the ends' functions times a bubble
  /// [degree - 3] the ends' normal equations once the bubbles are eliminated.
  std::array<Eigen::Matrix4d, max_degree - lowest_smooth_degree + 1> ends;

  explicit SegmentTable(std::size_t steps);
};

/// Tables made as they are asked for, by any thread.
class SegmentTables {
 public:
  /// For segments of 1 to `longest` steps.
  explicit SegmentTables(std::size_t longest) : made_(longest + 1), tables_(longest + 1) {}

  const SegmentTable& of(std::size_t steps);

 private:
  std::vector<std::once_flag> made_;
  std::vector<std::unique_ptr<const SegmentTable>> tables_;
};

}  // namespace sinew
