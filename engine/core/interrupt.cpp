#include "engine/core/interrupt.h"

#include <csignal>

namespace sinew {
namespace {

volatile std::sig_atomic_t caught = 0;

void on_signal(int signal) { caught = signal; }

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

Result<void> check_interrupt() {
  if (caught == SIGINT) return failure(ErrorKind::interrupted, "interrupted");
  if (caught == SIGTERM) return failure(ErrorKind::terminated, "terminated");
  return {};
}

}  // namespace sinew
