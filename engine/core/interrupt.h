#pragma once
/// SIGINT and SIGTERM, asked for between two pieces of work so that each is finished or dropped whole.

#include "engine/core/result.h"

namespace sinew {

/// From now on the first SIGINT or SIGTERM is only noted; a second one ends the program at once.
/// Writing beyond a file size limit or to a closed pipe fails like any other write.
void catch_interrupts();

/// While one lives, a signal ends the program at once, with exit code 130 or 143: for long work that is not in pieces
/// and has nothing open that could be left half done.
class EndAtOnce {
 public:
  EndAtOnce();
  ~EndAtOnce();
  EndAtOnce(const EndAtOnce&) = delete;
  EndAtOnce& operator=(const EndAtOnce&) = delete;
};

/// Fails as interrupted or terminated once a signal has come.
Result<void> check_interrupt();

}  // namespace sinew
