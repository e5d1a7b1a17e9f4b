#pragma once
/// How far a long piece of work has come, on stderr.

#include <chrono>
#include <string>

namespace sinew {

enum class ProgressStyle {
  automatic,  ///< a bar where stderr is a terminal, plain lines elsewhere
  bar,
  plain,  ///< a line every few seconds
  none,
};

/// Counts items of work. Says nothing of work that is done within a second.
class Progress {
 public:
  Progress(std::string what, std::size_t total, ProgressStyle style);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more item is done.
  void advance();

 private:
  using Clock = std::chrono::steady_clock;
  void show(Clock::time_point now);

  std::string what_;
  std::size_t total_, done_ = 0;
  ProgressStyle style_;
  Clock::time_point start_, next_;
  bool shown_ = false;
};

}  // namespace sinew
