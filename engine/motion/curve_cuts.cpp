#include "engine/motion/curve_cuts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace sinew {
namespace {

/// Turning points and the two ends, in order of time: an alternating row.
std::vector<std::size_t> turning_points(std::span<const double> values) {
  std::vector<std::size_t> turns{0};
  std::size_t plateau = 0;  // where the present value began
  int before = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (step == 0.0) continue;
    const int way = step > 0.0 ? 1 : -1;
    if (before != 0 && way != before) turns.push_back((plateau + i - 1) / 2);
    before = way;
    plateau = i;
  }
  turns.push_back(values.size() - 1);
  return turns;
}

/// A linked row of turning points, from which neighbours are taken out in pairs.
struct Turn {
  std::size_t before, after;
  bool gone = false;
};

}  // namespace

std::vector<Extremum> find_extrema(std::span<const double> values) {
  if (values.size() < 3) return {};
  const std::vector<std::size_t> turns = turning_points(values);
  const std::size_t count = turns.size();
  std::vector<Turn> row(count);
  for (std::size_t i = 0; i < count; ++i) row[i] = {i == 0 ? 0 : i - 1, i + 1};
  std::vector<double> prominence(count, std::numeric_limits<double>::infinity());
  const auto height = [&](std::size_t a, std::size_t b) { return std::abs(values[turns[a]] - values[turns[b]]); };

  struct Pair {
    double height;
    std::size_t left, right;
    bool operator>(const Pair& other) const {
      return height != other.height ? height > other.height : left > other.left;
    }
  };
  std::priority_queue<Pair, std::vector<Pair>, std::greater<>> pairs;
  for (std::size_t i = 0; i + 1 < count; ++i) pairs.push({height(i, i + 1), i, i + 1});
  while (!pairs.empty()) {
    const auto [h, left, right] = pairs.top();
    pairs.pop();
    if (row[left].gone || row[right].gone || row[left].after != right) continue;
    const bool at_begin = left == 0, at_end = right + 1 == count;
    if (at_begin && at_end) break;
    // A pair at an end: the end takes the turn's place, the turn alone is hidden.
    const auto remove = [&](std::size_t turn) {
      prominence[turn] = std::min(prominence[turn], h);
      row[turn].gone = true;
      row[row[turn].before].after = row[turn].after;
      row[row[turn].after].before = row[turn].before;
    };
    if (!at_begin) remove(left);
    if (!at_end) remove(right);
    const std::size_t a = at_begin ? left : row[left].before, b = at_end ? right : row[right].after;
    pairs.push({height(a, b), a, b});
  }
  std::vector<Extremum> extrema;
  for (std::size_t i = 1; i + 1 < count; ++i) extrema.push_back({turns[i], prominence[i]});
  // What never vanished is as prominent as the curve is high.
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  for (Extremum& extremum : extrema) extremum.prominence = std::min(extremum.prominence, *high - *low);
  return extrema;
}

}  // namespace sinew
