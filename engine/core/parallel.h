#pragma once
/// Loops over all cores. The result never depends on the number of threads: each index is worked on by itself.

#include <cstddef>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace sinew {

/// Calls body(i) for every i of 0..count-1, on any thread, in any order.
template <class Body>
void parallel_for(std::size_t count, const Body& body, std::size_t grain = 1024) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
                    });
}

}  // namespace sinew
