#pragma once
/// Where to cut a curve: near its extrema, the most prominent first.

#include <span>
#include <vector>

namespace sinew {

struct Extremum {
  std::size_t sample = 0;
  double prominence = 0.0;  ///< how far the curve must turn back on the smaller of its sides to hide it
};

/// The extrema of a row of values, its two ends left out, in order of time. Prominence is topological persistence: the
/// least prominent neighbours vanish together, a maximum with a minimum, and what is left stays an alternating row. Of
/// a plateau the middle counts.
std::vector<Extremum> find_extrema(std::span<const double> values);

}  // namespace sinew
