/// Part of the program that tests run to look for leaks.

#include <cstdlib>

// Drivers and layers let go of their libraries at the end, and whose memory was lost could not be said of a library
// that has gone: they stay.
extern "C" int dlclose(void*) { return 0; }

namespace {

/// Memory lost on purpose where SINEW_LOSE_MEMORY is set: so tests know that a loss is found.
const bool lost = [] {
  void* volatile block = nullptr;
  // Of several, no register or forgotten word of the stack points at all.
  for (int i = 0; std::getenv("SINEW_LOSE_MEMORY") != nullptr && i < 10; ++i) block = std::malloc(100);
  return block != nullptr;
}();

}  // namespace
