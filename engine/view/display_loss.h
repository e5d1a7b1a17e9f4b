#pragma once
/// The connection to a display can break at any call, and X's library then ends the program: what is done first.

#include <functional>

namespace sinew {

/// While one lives, `last_words` run where the connection to an X display breaks. The program then ends with the exit
/// code of a lost device, with or without them. Nothing on systems without X.
class DisplayLoss {
 public:
  explicit DisplayLoss(std::function<void()> last_words);
  ~DisplayLoss();
  DisplayLoss(const DisplayLoss&) = delete;
  DisplayLoss& operator=(const DisplayLoss&) = delete;
};

}  // namespace sinew
