#pragma once
/// The keys that the viewer knows.

#include <optional>

namespace sinew {

/// Keys by their place on a US keyboard; the number pad's numbers are numbers.
enum class KeyboardKey {
  f,
  k,
  m,
  p,
  q,
  r,
  s,
  y,
  z,
  one,
  three,
  five,
  seven,
  nine,
  period,
  space,
  tab,
  left,
  right,
  home,
  end,
  help
};

/// A key that went down, or was held long enough to count again.
struct KeyPress {
  KeyboardKey key;
  bool control = false, shift = false, again = false;
};

/// `code`: GLFW's, with or without Shift. Nothing where the viewer has no use for it.
std::optional<KeyboardKey> keyboard_key(int code, bool shift);

}  // namespace sinew
