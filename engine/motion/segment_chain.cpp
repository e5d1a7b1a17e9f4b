#include "engine/motion/segment_chain.h"

#include <Eigen/LU>

namespace sinew {

void ChainShape::clear(std::size_t segments) {
  knots.assign(segments + 1, Eigen::Vector2d::Zero());
  bubbles.assign(segments, {});
}

void ChainShape::add(const ChainShape& other, double times) {
  for (std::size_t i = 0; i < knots.size(); ++i) knots[i] += times * other.knots[i];
  for (std::size_t i = 0; i < bubbles.size(); ++i)
    for (int k = 0; k < most_bubbles; ++k) bubbles[i][k] += times * other.bubbles[i][k];
}

SegmentChain SegmentChain::part(std::size_t first, std::size_t end) const {
  const auto a = static_cast<std::ptrdiff_t>(first), b = static_cast<std::ptrdiff_t>(end);
  return {
      {segments.begin() + a, segments.begin() + b},
      {{shape.knots.begin() + a, shape.knots.begin() + b + 1}, {shape.bubbles.begin() + a, shape.bubbles.begin() + b}}};
}

void SegmentChain::replace(std::size_t first, std::size_t end, const SegmentChain& part) {
  const auto exchange = [](auto& row, std::size_t from, std::size_t to, const auto& with) {
    const auto at =
        row.erase(row.begin() + static_cast<std::ptrdiff_t>(from), row.begin() + static_cast<std::ptrdiff_t>(to));
    row.insert(at, with.begin(), with.end());
  };
  exchange(segments, first, end, part.segments);
  exchange(shape.bubbles, first, end, part.shape.bubbles);
  exchange(shape.knots, first, end + 1, part.shape.knots);
}

PiecewisePolynomial SegmentChain::curve(SegmentTables& tables, double begin, double spacing) const {
  PiecewisePolynomial curve;
  curve.cuts.push_back(begin + static_cast<double>(segments.front().first) * spacing);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    curve.cuts.push_back(begin + static_cast<double>(segments[i].last()) * spacing);
    const SegmentMatrix& basis = tables.of(segments[i].steps).legendre;
    SegmentVector unknowns(max_coefficients);
    unknowns.head<4>() << shape.knots[i], shape.knots[i + 1];
    for (int k = 0; k < most_bubbles; ++k) unknowns[end_unknowns + k] = shape.bubbles[i][k];
    const SegmentVector coefficients = basis * unknowns;
    curve.coefficients.emplace_back(coefficients.begin(), coefficients.begin() + segments[i].degree + 1);
  }
  return curve;
}

void ChainProjection::prepare(std::span<const ChainSegment> segments, bool fixed_begin, bool fixed_end) {
  const std::size_t count = segments.size();
  segments_.assign(segments.begin(), segments.end());
  of_.resize(count);
  pivot_inverse_.assign(count + 1, Eigen::Matrix2d::Zero());
  forward_.assign(count, Eigen::Matrix2d::Zero());
  Eigen::Matrix2d pivot = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    of_[i] = &tables_.of(segments[i].steps);
    const Eigen::Matrix4d& ends = of_[i]->ends[segments[i].bubbles()];
    pivot += ends.topLeftCorner<2, 2>();
    const Eigen::Matrix2d right = ends.topRightCorner<2, 2>();
    if (i > 0 || !fixed_begin) {
      pivot_inverse_[i] = pivot.inverse();
      forward_[i] = pivot_inverse_[i] * right;
    }
    pivot = ends.bottomRightCorner<2, 2>() - right.transpose() * forward_[i];
  }
  if (fixed_end) return;
  pivot(0, 0) += 1.0;  // the last sample of all, where every bubble is 0
  pivot_inverse_[count] = pivot.inverse();
}

void ChainProjection::project(std::span<const double> samples, ChainShape& shape) {
  const std::size_t count = segments_.size(), base = segments_.front().first;
  shape.clear(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, max_coefficients> sums{};
    const double* sample = &samples[segments_[i].first - base];
    for (std::size_t s = 0; s < segments_[i].steps; ++s) {
      if (sample[s] == 0.0) continue;
      const auto& basis = of_[i]->basis[s];
      for (int k = 0; k < max_coefficients; ++k) sums[k] += sample[s] * basis[k];
    }
    Eigen::Vector4d ends(sums[0], sums[1], sums[2], sums[3]);
    for (int k = 0; k < segments_[i].bubbles(); ++k) {
      shape.bubbles[i][k] = sums[end_unknowns + k];
      ends -= sums[end_unknowns + k] * of_[i]->coupling[k];
    }
    shape.knots[i] += ends.head<2>();
    shape.knots[i + 1] += ends.tail<2>();
  }
  shape.knots[count][0] += samples[segments_.back().last() - base];
  for (std::size_t i = 0; i < count; ++i) shape.knots[i + 1] -= forward_[i].transpose() * shape.knots[i];
  for (std::size_t i = count + 1; i-- > 0;) {
    shape.knots[i] = (pivot_inverse_[i] * shape.knots[i]).eval();
    if (i < count) shape.knots[i] -= forward_[i] * shape.knots[i + 1];
  }
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Vector4d ends;
    ends << shape.knots[i], shape.knots[i + 1];
    for (int k = 0; k < segments_[i].bubbles(); ++k) shape.bubbles[i][k] -= of_[i]->coupling[k].dot(ends);
  }
}

void ChainProjection::evaluate(const ChainShape& shape, std::span<double> values) const {
  const std::size_t base = segments_.front().first;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Eigen::Vector2d &a = shape.knots[i], &b = shape.knots[i + 1];
    const auto& bubbles = shape.bubbles[i];
    double* value = &values[segments_[i].first - base];
    for (std::size_t s = 0; s <= segments_[i].steps; ++s) {
      const auto& basis = of_[i]->basis[s];
      double sum = a[0] * basis[0] + a[1] * basis[1] + b[0] * basis[2] + b[1] * basis[3];
      for (int k = 0; k < most_bubbles; ++k) sum += bubbles[k] * basis[end_unknowns + k];
      value[s] = sum;
    }
  }
}

}  // namespace sinew
