#include "engine/core/interrupt.h"

#include <unistd.h>

#include <csignal>
#include <string_view>

namespace sinew {
namespace {

volatile std::sig_atomic_t caught = 0;
volatile std::sig_atomic_t at_once = 0;  ///< how many EndAtOnce live

void on_signal(int signal) {
  caught = signal;
  if (at_once == 0) return;
  constexpr std::string_view message = "error: stopped by a signal\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, message.data(), message.size());
  ::_exit(128 + signal);
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = &on_signal;
  // The handler is taken off as it runs, so that a second signal has its usual effect.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A file that may not grow and a reader that went away are write errors, not reasons to die half-way.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

EndAtOnce::EndAtOnce() { at_once = at_once + 1; }

EndAtOnce::~EndAtOnce() { at_once = at_once - 1; }

Result<void> check_interrupt() {
  if (caught == SIGINT) return failure(ErrorKind::interrupted, "interrupted");
  if (caught == SIGTERM) return failure(ErrorKind::terminated, "terminated");
  return {};
}

}  // namespace sinew
