#pragma once
/// Times of a stage that ran many times.

#include <chrono>
#include <vector>

#include "engine/app/bench.h"

namespace sinew {

/// 0 where there are none.
double median(std::vector<double> values);

Timing timing(std::vector<double> values);

/// What a call takes by the clock on the wall.
template <class Call>
double milliseconds(Call&& call) {
  const auto begun = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
}

}  // namespace sinew
