#pragma once
/// A long piece of work seen from another thread: how far it has come, and a way to stop it.

#include <atomic>
#include <cstddef>
#include <functional>

#include "engine/core/result.h"

namespace sinew {

/// Asked between two pieces of work; fails once it is to stop.
using StopCheck = std::function<Result<void>()>;

/// One side works and counts, the other looks and may cancel. All calls from any thread.
class TaskWatch {
 public:
  /// `total` items are to be done.
  void begin(std::size_t total) {
    done_ = 0;
    total_ = total;
  }
  /// So many more, as it turns out.
  void add(std::size_t more) { total_ += more; }
  void advance() { ++done_; }
  void cancel() { cancelled_ = true; }

  bool is_cancelled() const { return cancelled_; }
  /// 0 to 1; 0 while nothing is known.
  double share() const {
    const std::size_t total = total_;
    return total == 0 ? 0.0 : static_cast<double>(done_) / static_cast<double>(total);
  }
  /// Fails as interrupted once cancelled: to be asked between two items.
  Result<void> check() const {
    if (cancelled_) return failure(ErrorKind::interrupted, "stopped");
    return {};
  }

 private:
  std::atomic<std::size_t> done_ = 0, total_ = 0;
  std::atomic<bool> cancelled_ = false;
};

}  // namespace sinew
