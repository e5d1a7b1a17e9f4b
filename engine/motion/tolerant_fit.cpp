#include "engine/motion/tolerant_fit.h"

#include <algorithm>
#include <cmath>

#include "engine/motion/curve_cuts.h"

namespace sinew {
namespace {

/// A polynomial's lone error must be below the tolerance by this much before it is tried among its neighbours, whose
/// joints cost it some of its freedom.
constexpr double reserve = 0.8;

class TolerantFit {
 public:
  TolerantFit(SmoothFitter& fitter, double tolerance, int highest_degree)
      : fitter_(fitter), tolerance_(tolerance), highest_(highest_degree) {}

  void start(Segmentation segmentation) {
    segmentation_ = std::move(segmentation);
    measure();
  }
  /// More degrees, and where `may_cut` more cuts, until the tolerance holds or nothing helps.
  void refine(bool may_cut);
  /// Fewer cuts, then fewer degrees, while the tolerance holds.
  void prune(bool may_merge);

  PiecewisePolynomial curve() && { return std::move(curve_); }
  /// The least degree that is likely to hold the tolerance over these samples, or 0.
  int sufficient_degree(std::size_t first, std::size_t last, int from = lowest_smooth_degree);

 private:
  void measure();
  double worst_in(const PiecewisePolynomial& curve, const Segmentation& segmentation, std::size_t segment) const;
  bool holds() const;
  int most_degree(std::size_t first, std::size_t last) const {
    return std::clamp(static_cast<int>(std::min<std::size_t>(last - first, max_degree)), lowest_smooth_degree,
                      highest_);
  }
  void append_halves(Segmentation& next, std::size_t first, std::size_t last);
  bool try_segmentation(const Segmentation& trial);
  bool merge_at(std::size_t cut);

  SmoothFitter& fitter_;
  double tolerance_;
  int highest_;
  Segmentation segmentation_;
  PiecewisePolynomial curve_;
  std::vector<double> worst_;  ///< [segments] largest distance of a sample
};

double TolerantFit::worst_in(const PiecewisePolynomial& curve, const Segmentation& segmentation,
                             std::size_t segment) const {
  double worst = 0.0;
  for (std::size_t i = segmentation.cuts[segment]; i <= segmentation.cuts[segment + 1]; ++i)
    worst = std::max(worst, std::abs(curve.value_in(segment, fitter_.times()[i]) - fitter_.values()[i]));
  return worst;
}

void TolerantFit::measure() {
  curve_ = fitter_.fit(segmentation_);
  worst_.resize(segmentation_.segments());
  for (std::size_t i = 0; i < worst_.size(); ++i) worst_[i] = worst_in(curve_, segmentation_, i);
}

bool TolerantFit::holds() const {
  return std::all_of(worst_.begin(), worst_.end(), [&](double worst) { return worst <= tolerance_; });
}

int TolerantFit::sufficient_degree(std::size_t first, std::size_t last, int from) {
  for (int degree = from; degree <= most_degree(first, last); ++degree)
    if (fitter_.lone_error(first, last, degree) <= reserve * tolerance_) return degree;
  return 0;
}

/// Cut at the most prominent extremum away from the ends, or in the middle.
void TolerantFit::append_halves(Segmentation& next, std::size_t first, std::size_t last) {
  std::size_t cut = (first + last) / 2;
  double best = 0.0;
  const std::size_t margin = (last - first) / 5;
  for (const Extremum& extremum : find_extrema(fitter_.values().subspan(first, last - first + 1)))
    if (extremum.sample >= margin && extremum.sample + margin <= last - first &&
        extremum.prominence > std::max(best, tolerance_)) {
      best = extremum.prominence;
      cut = first + extremum.sample;
    }
  const int left = sufficient_degree(first, cut), right = sufficient_degree(cut, last);
  next.degrees.push_back(left > 0 ? left : most_degree(first, cut));
  next.cuts.push_back(cut);
  next.degrees.push_back(right > 0 ? right : most_degree(cut, last));
}

void TolerantFit::refine(bool may_cut) {
  while (!holds()) {
    Segmentation next{{0}, {}};
    bool changed = false;
    for (std::size_t i = 0; i < segmentation_.segments(); ++i) {
      const std::size_t first = segmentation_.cuts[i], last = segmentation_.cuts[i + 1];
      const int degree = segmentation_.degrees[i], most = most_degree(first, last);
      int wanted = degree;
      if (worst_[i] > tolerance_ && degree < most) {
        wanted = sufficient_degree(first, last, degree + 1);
        if (wanted == 0 && !may_cut) wanted = most;
      }
      const bool cut = may_cut && worst_[i] > tolerance_ && last - first > 1 && (degree >= most || wanted == 0);
      if (cut) {
        append_halves(next, first, last);
      } else {
        next.degrees.push_back(wanted == 0 ? most : wanted);
      }
      changed |= cut || next.degrees.back() != degree;
      next.cuts.push_back(last);
    }
    if (!changed) return;
    start(std::move(next));
  }
}

/// Takes the trial where it holds. Segments that stay and hardly move are not measured again.
bool TolerantFit::try_segmentation(const Segmentation& trial) {
  PiecewisePolynomial curve = fitter_.fit(trial);
  std::vector<double> worst(trial.segments());
  std::size_t old = 0;
  for (std::size_t i = 0; i < trial.segments(); ++i) {
    while (segmentation_.cuts[old] < trial.cuts[i]) ++old;
    const bool same = segmentation_.cuts[old] == trial.cuts[i] && segmentation_.cuts[old + 1] == trial.cuts[i + 1] &&
                      segmentation_.degrees[old] == trial.degrees[i];
    double bound = INFINITY;
    if (same) {  // |P_k| <= 1
      bound = worst_[old];
      for (std::size_t k = 0; k < curve.coefficients[i].size(); ++k)
        bound += std::abs(curve.coefficients[i][k] - curve_.coefficients[old][k]);
    }
    worst[i] = bound <= tolerance_ ? bound : worst_in(curve, trial, i);
    if (worst[i] > tolerance_) return false;
  }
  segmentation_ = trial;
  curve_ = std::move(curve);
  worst_ = std::move(worst);
  return true;
}

bool TolerantFit::merge_at(std::size_t cut) {
  const std::size_t first = segmentation_.cuts[cut - 1], last = segmentation_.cuts[cut + 1];
  const int degree = sufficient_degree(first, last);
  if (degree == 0 || degree >= segmentation_.degrees[cut - 1] + segmentation_.degrees[cut]) return false;
  Segmentation trial = segmentation_;
  trial.cuts.erase(trial.cuts.begin() + static_cast<std::ptrdiff_t>(cut));
  trial.degrees.erase(trial.degrees.begin() + static_cast<std::ptrdiff_t>(cut));
  for (int d = degree; d <= std::min(degree + 1, most_degree(first, last)); ++d) {
    trial.degrees[cut - 1] = d;
    if (try_segmentation(trial)) return true;
  }
  return false;
}

void TolerantFit::prune(bool may_merge) {
  if (!holds()) return;
  for (bool merged = may_merge; merged;) {
    merged = false;
    for (std::size_t cut = 1; cut < segmentation_.segments();)
      if (merge_at(cut))
        merged = true;
      else
        ++cut;
  }
  for (std::size_t i = 0; i < segmentation_.segments(); ++i)
    while (segmentation_.degrees[i] > lowest_smooth_degree) {
      Segmentation trial = segmentation_;
      --trial.degrees[i];
      if (!try_segmentation(trial)) break;
    }
}

Segmentation lowest_degrees(std::vector<std::size_t> cuts) {
  const std::size_t segments = cuts.size() - 1;
  return {std::move(cuts), std::vector<int>(segments, lowest_smooth_degree)};
}

}  // namespace

PiecewisePolynomial fit_within(SmoothFitter& fitter, double tolerance, int highest_degree) {
  const std::size_t last = fitter.times().size() - 1;
  for (int degree = 0; degree <= std::min<int>(highest_degree, static_cast<int>(std::min<std::size_t>(last, 8)));
       ++degree)
    if (fitter.lone_error(0, last, degree) <= tolerance) return fitter.lone_fit(degree);
  std::vector<std::size_t> cuts{0};
  for (const Extremum& extremum : find_extrema(fitter.values()))
    if (extremum.prominence > 2.0 * tolerance) cuts.push_back(extremum.sample);
  cuts.push_back(last);
  TolerantFit fit(fitter, tolerance, highest_degree);
  Segmentation segmentation = lowest_degrees(std::move(cuts));
  for (std::size_t i = 0; i < segmentation.segments(); ++i)
    segmentation.degrees[i] =
        std::max(fit.sufficient_degree(segmentation.cuts[i], segmentation.cuts[i + 1]), lowest_smooth_degree);
  fit.start(std::move(segmentation));
  fit.refine(true);
  fit.prune(true);
  return std::move(fit).curve();
}

PiecewisePolynomial fit_degrees_within(SmoothFitter& fitter, const std::vector<std::size_t>& cuts, double tolerance,
                                       int highest_degree) {
  TolerantFit fit(fitter, tolerance, highest_degree);
  fit.start(lowest_degrees(cuts));
  fit.refine(false);
  fit.prune(false);
  return std::move(fit).curve();
}

}  // namespace sinew
