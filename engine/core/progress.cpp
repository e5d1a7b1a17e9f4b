#include "engine/core/progress.h"

#include <unistd.h>

#include <fmt/format.h>

namespace sinew {
namespace {

using Seconds = std::chrono::duration<double>;
constexpr int bar_width = 30;

}  // namespace

Progress::Progress(std::string what, std::size_t total, ProgressStyle style)
    : what_(std::move(what)),
      total_(total),
      style_(style),
      start_(Clock::now()),
      next_(start_ + std::chrono::seconds(1)) {
  if (style_ == ProgressStyle::automatic)
    style_ = ::isatty(STDERR_FILENO) != 0 ? ProgressStyle::bar : ProgressStyle::plain;
}

Progress::~Progress() {
  if (shown_ && style_ == ProgressStyle::bar) fmt::print(stderr, "\n");
}

void Progress::advance() {
  ++done_;
  const Clock::time_point now = Clock::now();
  const bool last = done_ == total_;
  if (style_ == ProgressStyle::none || (now < next_ && !(last && shown_))) return;
  show(now);
  next_ = now + (style_ == ProgressStyle::bar ? std::chrono::milliseconds(100) : std::chrono::milliseconds(3000));
}

void Progress::show(Clock::time_point now) {
  shown_ = true;
  const double elapsed = Seconds(now - start_).count();
  const double rate = static_cast<double>(done_) / elapsed;
  const double left = static_cast<double>(total_ - done_) / rate;
  if (style_ == ProgressStyle::plain) {
    fmt::print(stderr, "{}: {} of {}, {:.1f} a second, {:.0f} s left\n", what_, done_, total_, rate, left);
    return;
  }
  const int filled = static_cast<int>(bar_width * done_ / std::max<std::size_t>(total_, 1));
  fmt::print(stderr, "\r{} [{:<{}}] {}/{} {:.1f}/s {:.0f} s left ", what_, std::string(filled, '#'), bar_width, done_,
             total_, rate, left);
}

}  // namespace sinew
