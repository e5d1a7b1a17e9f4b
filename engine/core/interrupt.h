#pragma once
/// SIGINT and SIGTERM, asked for between two pieces of work so that each is finished or dropped whole.

#include "engine/core/result.h"

namespace sinew {

/// From now on the first SIGINT or SIGTERM is only noted; a second one ends the program at once.
/// Writing beyond a file size limit or to a closed pipe fails like any other write.
void catch_interrupts();

/// Fails as interrupted or terminated once a signal has come.
Result<void> check_interrupt();

}  // namespace sinew
