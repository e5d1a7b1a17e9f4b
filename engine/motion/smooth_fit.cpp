#include "engine/motion/smooth_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace sinew {
namespace {

using Ends = Eigen::Matrix4d;
using Couplings = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::ColMajor, max_coefficients - end_unknowns, 4>;

/// A segment's part of the normal equations, its bubbles eliminated.
struct Element {
  SegmentMatrix basis;  ///< to Legendre's coefficients
  Couplings carried;    ///< bubbles' block^-1 times their coupling to the ends
  SegmentVector free;   ///< the bubbles where all ends are 0
  Ends matrix;          ///< what is left for the ends
  Eigen::Vector4d right;
};

Element element(const SegmentMatrix& gram, const SegmentVector& moment, int degree, double length, double slope_unit,
                double penalty) {
  Element e;
  const int n = degree + 1, inner = n - end_unknowns;
  e.basis = smooth_basis(degree, length, slope_unit);
  const double to_seconds = 8.0 / (length * length * length);  // of the second derivatives' integral
  const SegmentMatrix sum = gram.topLeftCorner(n, n) + penalty * to_seconds * curvature_integrals(degree);
  const SegmentMatrix whole = e.basis.transpose() * sum * e.basis;
  const SegmentVector right = e.basis.transpose() * moment.head(n);
  e.matrix = whole.topLeftCorner<4, 4>();
  e.right = right.head<4>();
  if (inner == 0) return e;
  const Eigen::LLT<SegmentMatrix> bubbles(whole.bottomRightCorner(inner, inner));
  e.carried = bubbles.solve(whole.bottomLeftCorner(inner, 4));
  e.free = bubbles.solve(right.tail(inner));
  e.matrix.noalias() -= whole.topRightCorner(4, inner) * e.carried;
  e.right.noalias() -= whole.topRightCorner(4, inner) * e.free;
  return e;
}

/// The ends' equations, 2x2 blocks on three diagonals, by Cholesky's elimination.
struct EndSystem {
  std::vector<Eigen::Matrix2d> pivot_inverse;  ///< [nodes]
  std::vector<Eigen::Matrix2d> forward;        ///< [nodes - 1] pivot^-1 times the block to its right
  std::vector<Eigen::Vector2d> solution;       ///< [nodes] value and slope

  explicit EndSystem(const std::vector<Element>& elements);
};

EndSystem::EndSystem(const std::vector<Element>& elements) {
  const std::size_t nodes = elements.size() + 1;
  pivot_inverse.resize(nodes);
  forward.resize(nodes - 1);
  solution.assign(nodes, Eigen::Vector2d::Zero());
  std::vector<Eigen::Matrix2d> pivot(nodes, Eigen::Matrix2d::Zero());
  for (std::size_t i = 0; i + 1 < nodes; ++i) {
    pivot[i] += elements[i].matrix.topLeftCorner<2, 2>();
    pivot[i + 1] += elements[i].matrix.bottomRightCorner<2, 2>();
    solution[i] += elements[i].right.head<2>();
    solution[i + 1] += elements[i].right.tail<2>();
  }
  for (std::size_t i = 0; i < nodes; ++i) {
    pivot_inverse[i] = pivot[i].inverse();
    if (i + 1 == nodes) break;
    const Eigen::Matrix2d right = elements[i].matrix.topRightCorner<2, 2>();
    forward[i] = pivot_inverse[i] * right;
    pivot[i + 1] -= right.transpose() * forward[i];
    solution[i + 1] -= forward[i].transpose() * solution[i];
  }
  for (std::size_t i = nodes; i-- > 0;) {
    solution[i] = (pivot_inverse[i] * solution[i]).eval();
    if (i + 1 < nodes) solution[i] -= forward[i] * solution[i + 1];
  }
}

}  // namespace

std::size_t Segmentation::stored_numbers() const {
  std::size_t numbers = 2 * cuts.size() + segments() - 1;
  for (const int degree : degrees) numbers += static_cast<std::size_t>(degree) - 3;
  return numbers;
}

SmoothFitter::SmoothFitter(std::span<const double> times, std::span<const double> values)
    : times_(times), values_(values) {
  assert(times.size() >= 2 && times.size() == values.size());
  spacing_ = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

const SmoothFitter::Sums& SmoothFitter::sums(std::size_t first, std::size_t last) {
  const auto [at, is_new] = sums_.try_emplace(std::uint64_t{first} << 32 | last);
  Sums& sums = at->second;
  if (!is_new) return sums;
  const double middle = 0.5 * (times_[first] + times_[last]), scale = 2.0 / (times_[last] - times_[first]);
  const std::size_t end = last + 1 == times_.size() ? last + 1 : last;
  Eigen::Matrix<double, max_coefficients, max_coefficients> gram;
  Eigen::Matrix<double, max_coefficients, 1> moment;
  gram.setZero();
  moment.setZero();
  for (std::size_t i = first; i < end; ++i) {
    const LegendreValues p = legendre_values((times_[i] - middle) * scale);
    for (int a = 0; a < max_coefficients; ++a) {
      for (int b = 0; b <= a; ++b) gram(a, b) += p[a] * p[b];
      moment[a] += p[a] * values_[i];
    }
  }
  sums.gram = gram.selfadjointView<Eigen::Lower>();
  sums.moment = moment;
  return sums;
}

PiecewisePolynomial SmoothFitter::fit(const Segmentation& segmentation) {
  const std::size_t segments = segmentation.segments();
  assert(segments >= 1 && segmentation.cuts.size() == segments + 1);
  assert(segmentation.cuts.front() == 0 && segmentation.cuts.back() + 1 == times_.size());
  // A millionth of what one sample weighs against the curvature of a segment from it to the next.
  const double penalty = 1e-7 * spacing_ * spacing_ * spacing_;
  const double slope_unit = 0.5 * (times_.back() - times_.front()) / static_cast<double>(segments);
  std::vector<Element> elements;
  elements.reserve(segments);
  for (std::size_t i = 0; i < segments; ++i) {
    const std::size_t first = segmentation.cuts[i], last = segmentation.cuts[i + 1];
    const Sums& s = sums(first, last);
    elements.push_back(
        element(s.gram, s.moment, segmentation.degrees[i], times_[last] - times_[first], slope_unit, penalty));
  }
  const EndSystem ends(elements);

  PiecewisePolynomial curve;
  for (const std::size_t cut : segmentation.cuts) curve.cuts.push_back(times_[cut]);
  for (std::size_t i = 0; i < segments; ++i) {
    const Element& e = elements[i];
    SegmentVector unknowns(e.basis.cols());
    unknowns.head<4>() << ends.solution[i], ends.solution[i + 1];
    if (e.basis.cols() > end_unknowns)
      unknowns.tail(e.basis.cols() - end_unknowns) = e.free - e.carried * unknowns.head<4>();
    const SegmentVector coefficients = e.basis * unknowns;
    curve.coefficients.emplace_back(coefficients.begin(), coefficients.end());
  }
  return curve;
}

SegmentVector SmoothFitter::lone_coefficients(std::size_t first, std::size_t last, int degree) {
  const Sums& s = sums(first, last);
  const std::size_t samples = last - first + (last + 1 == times_.size() ? 1 : 0);
  const auto n = static_cast<Eigen::Index>(std::min<std::size_t>(degree + 1, samples));
  return SegmentMatrix(s.gram.topLeftCorner(n, n)).ldlt().solve(SegmentVector(s.moment.head(n)));
}

double SmoothFitter::lone_error(std::size_t first, std::size_t last, int degree) {
  const SegmentVector c = lone_coefficients(first, last, degree);
  const double middle = 0.5 * (times_[first] + times_[last]), scale = 2.0 / (times_[last] - times_[first]);
  double largest = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    const double f = legendre_sum({c.data(), static_cast<std::size_t>(c.size())}, (times_[i] - middle) * scale);
    largest = std::max(largest, std::abs(f - values_[i]));
  }
  return largest;
}

PiecewisePolynomial SmoothFitter::lone_fit(int degree) {
  const SegmentVector c = lone_coefficients(0, times_.size() - 1, degree);
  return {{times_.front(), times_.back()}, {{c.begin(), c.end()}}};
}

std::vector<double> residuals(const PiecewisePolynomial& curve, std::span<const double> times,
                              std::span<const double> values) {
  std::vector<double> distances(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) distances[i] = values[i] - curve.value(times[i]);
  return distances;
}

}  // namespace sinew
