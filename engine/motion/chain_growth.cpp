#include "engine/motion/chain_growth.h"

#include <algorithm>
#include <cmath>

#include "engine/motion/curve_cuts.h"
#include "engine/motion/smooth_fit.h"

namespace sinew {
namespace {

constexpr std::size_t first_guess = 30;  ///< steps
/// A segment that ends this early has a slope to begin with that leads nowhere.
constexpr std::size_t stuck = 8;
/// A segment at its longest ends at the edge of the tube, from where the next has little freedom.
constexpr double give_back = 0.05;
/// How far back, of its length, a segment is cut for an extremum's sake. More cuts stand at extrema for it, at no cost.
constexpr double extremum_reach = 0.3;

class Growth {
 public:
  Growth(TubeFit& tube, int degree)
      : tube_(tube), degree_(degree), last_(tube.values().size() - 1), extrema_(find_extrema(tube.values())) {}

  SegmentChain run() {
    while (end_ < last_) step();
    return std::move(chain_);
  }

 private:
  /// The segment before, whose end may still move, and a new one.
  struct Tail {
    SegmentChain chain;
    std::size_t steps = 0;  ///< of the new one; 0: none was found
  };

  void step();
  Tail longest(std::size_t most);
  std::optional<Tail> attempt(std::size_t steps);
  bool bridge(std::size_t reached);
  std::size_t place_of_cut(std::size_t steps) const;
  void append(const Tail& tail);
  int degree_for(std::size_t steps) const {
    return std::clamp(static_cast<int>(std::min<std::size_t>(steps, max_degree)), lowest_smooth_degree, degree_);
  }

  TubeFit& tube_;
  int degree_;
  std::size_t last_, end_ = 0, guess_ = first_guess;
  std::vector<Extremum> extrema_;
  SegmentChain chain_;
};

std::optional<Growth::Tail> Growth::attempt(std::size_t steps) {
  const std::size_t count = chain_.segments.size(), kept = std::min<std::size_t>(count, 1);
  Tail tail{kept > 0 ? chain_.part(count - 1, count) : SegmentChain{}, steps};
  if (kept == 0) tail.chain.shape.clear(0);
  tail.chain.segments.push_back({end_, steps, degree_for(steps)});
  tail.chain.shape.knots.emplace_back(Eigen::Vector2d::Zero());
  tail.chain.shape.bubbles.push_back({});
  if (tube_.hold(tail.chain, kept < count, false)) return tail;
  if (steps > 1 || count == 0) return {};
  // One step has no sample inside: it goes straight to the next, whatever the slope it came with.
  tail.chain.replace(0, 1, chain_.part(count - 1, count));
  const std::span<const double> values = tube_.values();
  tail.chain.shape.knots.back() = {values[end_ + 1], values[end_ + 1] - values[end_]};
  tail.chain.shape.bubbles.back() = {};
  return tail;
}

/// Doubling and halving, then bisection to a thirtieth.
Growth::Tail Growth::longest(std::size_t most) {
  Tail best;
  std::size_t fails = most + 1;
  for (std::size_t steps = std::min(guess_, most); steps > 0 && steps < fails;) {
    if (auto tail = attempt(steps)) {
      best = std::move(*tail);
      if (fails <= most) break;
      steps = std::min(most, std::max(steps + 2, steps * 13 / 10));
      if (best.steps == most) break;
    } else {
      fails = steps;
      if (best.steps > 0) break;
      steps = steps > 1 ? std::max<std::size_t>(1, steps * 3 / 4) : 0;
    }
  }
  while (best.steps > 0 && fails - best.steps > std::max<std::size_t>(1, best.steps / 32)) {
    const std::size_t steps = (fails + best.steps) / 2;
    if (auto tail = attempt(steps))
      best = std::move(*tail);
    else
      fails = steps;
  }
  return best;
}

/// The most prominent extremum not far before the end; without one, a little before it.
std::size_t Growth::place_of_cut(std::size_t steps) const {
  const auto length = static_cast<double>(steps);
  const auto earliest = end_ + static_cast<std::size_t>(length * (1.0 - extremum_reach));
  const auto latest = end_ + static_cast<std::size_t>(std::ceil(length * (1.0 - 0.5 * give_back)));
  double prominence = 2.0 * tube_.tolerance();
  std::size_t cut = end_ + std::max<std::size_t>(1, static_cast<std::size_t>(length * (1.0 - give_back)));
  auto extremum = std::lower_bound(extrema_.begin(), extrema_.end(), earliest,
                                   [](const Extremum& e, std::size_t sample) { return e.sample < sample; });
  for (; extremum != extrema_.end() && extremum->sample <= latest; ++extremum)
    if (extremum->prominence > prominence && extremum->sample > end_) {
      prominence = extremum->prominence;
      cut = extremum->sample;
    }
  return cut - end_;
}

/// One step, cubic, to where a segment that need not heed the row before would begin.
bool Growth::bridge(std::size_t reached) {
  for (std::size_t steps = std::min(first_guess, last_ - end_ - 1); steps > reached + 1; steps = steps * 2 / 3) {
    SegmentChain fresh = chain_of({{end_ + 1, end_ + 1 + steps}, {degree_for(steps)}});
    if (!tube_.hold(fresh, false, false)) continue;
    chain_.segments.push_back({end_, 1, lowest_smooth_degree});
    chain_.shape.bubbles.push_back({});
    chain_.shape.knots.push_back(fresh.shape.knots.front());
    end_ += 1;
    guess_ = steps;
    return true;
  }
  return false;
}

void Growth::append(const Tail& tail) {
  const std::size_t count = chain_.segments.size();
  if (count == 0)
    chain_ = tail.chain;
  else
    chain_.replace(count - 1, count, tail.chain);
  end_ += tail.steps;
}

void Growth::step() {
  const std::size_t most = std::min(last_ - end_, longest_grown);
  Tail tail = longest(most);
  guess_ = std::max<std::size_t>(tail.steps, 1);
  if (tail.steps < std::min(stuck, last_ - end_) && !chain_.segments.empty() && bridge(tail.steps)) return;
  if (tail.steps < last_ - end_ && tail.steps > stuck)
    if (auto shorter = attempt(place_of_cut(tail.steps))) tail = std::move(*shorter);
  append(tail);
}

}  // namespace

SegmentChain grow_chain(TubeFit& tube, int degree) { return Growth(tube, degree).run(); }

}  // namespace sinew
