#include "engine/view/keyboard.h"

#include <GLFW/glfw3.h>

namespace sinew {

std::optional<KeyboardKey> keyboard_key(int code, bool shift) {
  switch (code) {
    case GLFW_KEY_F:
      return KeyboardKey::f;
    case GLFW_KEY_K:
      return KeyboardKey::k;
    case GLFW_KEY_M:
      return KeyboardKey::m;
    case GLFW_KEY_P:
      return KeyboardKey::p;
    case GLFW_KEY_Q:
      return KeyboardKey::q;
    case GLFW_KEY_R:
      return KeyboardKey::r;
    case GLFW_KEY_S:
      return KeyboardKey::s;
    case GLFW_KEY_Y:
      return KeyboardKey::y;
    case GLFW_KEY_Z:
      return KeyboardKey::z;
    case GLFW_KEY_1:
    case GLFW_KEY_KP_1:
      return KeyboardKey::one;
    case GLFW_KEY_3:
    case GLFW_KEY_KP_3:
      return KeyboardKey::three;
    case GLFW_KEY_5:
    case GLFW_KEY_KP_5:
      return KeyboardKey::five;
    case GLFW_KEY_7:
    case GLFW_KEY_KP_7:
      return KeyboardKey::seven;
    case GLFW_KEY_9:
    case GLFW_KEY_KP_9:
      return KeyboardKey::nine;
    case GLFW_KEY_PERIOD:
    case GLFW_KEY_KP_DECIMAL:
      return KeyboardKey::period;
    case GLFW_KEY_SPACE:
      return KeyboardKey::space;
    case GLFW_KEY_TAB:
      return KeyboardKey::tab;
    case GLFW_KEY_LEFT:
      return KeyboardKey::left;
    case GLFW_KEY_RIGHT:
      return KeyboardKey::right;
    case GLFW_KEY_HOME:
      return KeyboardKey::home;
    case GLFW_KEY_END:
      return KeyboardKey::end;
    case GLFW_KEY_F1:
      return KeyboardKey::help;
    case GLFW_KEY_SLASH:
      return shift ? std::optional(KeyboardKey::help) : std::nullopt;
    default:
      return std::nullopt;
  }
}

}  // namespace sinew
