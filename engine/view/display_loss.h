#pragma once
/// The connection to a display can break at any call, and X's library then ends the program: what is done first.

#include <functional>

namespace sinew {

/// Where the connection to an X display breaks, `last_words` run, and the program ends with the exit code of a lost
/// device. Replaces what was asked for before. Nothing on systems without X.
void at_display_loss(std::function<void()> last_words);

}  // namespace sinew
