// SPDX-License-Identifier: MIT
// From GLFW's keys to keys by what they print.
#include "host/glfw_keys.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>

namespace vides {
namespace {

KeyboardKey offset(KeyboardKey first, int steps) {
  return static_cast<KeyboardKey>(static_cast<int>(first) + steps);
}

struct Row {
  int token;
  KeyboardKey key;
};
constexpr std::array kKeys = {
    Row{GLFW_KEY_SPACE, KeyboardKey::kSpace},
    Row{GLFW_KEY_ESCAPE, KeyboardKey::kEscape},
    Row{GLFW_KEY_ENTER, KeyboardKey::kEnter},
    Row{GLFW_KEY_TAB, KeyboardKey::kTab},
    Row{GLFW_KEY_BACKSPACE, KeyboardKey::kBackspace},
    Row{GLFW_KEY_INSERT, KeyboardKey::kInsert},
    Row{GLFW_KEY_DELETE, KeyboardKey::kDelete},
    Row{GLFW_KEY_LEFT, KeyboardKey::kLeft},
    Row{GLFW_KEY_RIGHT, KeyboardKey::kRight},
    Row{GLFW_KEY_UP, KeyboardKey::kUp},
    Row{GLFW_KEY_DOWN, KeyboardKey::kDown},
    Row{GLFW_KEY_PAGE_UP, KeyboardKey::kPageUp},
    Row{GLFW_KEY_PAGE_DOWN, KeyboardKey::kPageDown},
    Row{GLFW_KEY_HOME, KeyboardKey::kHome},
    Row{GLFW_KEY_END, KeyboardKey::kEnd},
    Row{GLFW_KEY_MENU, KeyboardKey::kMenu},
    Row{GLFW_KEY_KP_DECIMAL, KeyboardKey::kPadDecimal},
    Row{GLFW_KEY_KP_DIVIDE, KeyboardKey::kPadDivide},
    Row{GLFW_KEY_KP_MULTIPLY, KeyboardKey::kPadMultiply},
    Row{GLFW_KEY_KP_SUBTRACT, KeyboardKey::kPadSubtract},
    Row{GLFW_KEY_KP_ADD, KeyboardKey::kPadAdd},
    Row{GLFW_KEY_KP_ENTER, KeyboardKey::kPadEnter},
    Row{GLFW_KEY_KP_EQUAL, KeyboardKey::kEqual},
    Row{GLFW_KEY_LEFT_SHIFT, KeyboardKey::kLeftShift},
    Row{GLFW_KEY_RIGHT_SHIFT, KeyboardKey::kRightShift},
    Row{GLFW_KEY_LEFT_CONTROL, KeyboardKey::kLeftControl},
    Row{GLFW_KEY_RIGHT_CONTROL, KeyboardKey::kRightControl},
    Row{GLFW_KEY_LEFT_ALT, KeyboardKey::kLeftAlt},
    Row{GLFW_KEY_RIGHT_ALT, KeyboardKey::kRightAlt},
    Row{GLFW_KEY_LEFT_SUPER, KeyboardKey::kLeftSuper},
    Row{GLFW_KEY_RIGHT_SUPER, KeyboardKey::kRightSuper},
};

bool beyondAscii(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
}

}  // namespace

KeyboardKey keyFromGlfw(int token, std::string_view printed) {
  for (const Row& row : kKeys) {
    if (row.token == token) return row.key;
  }
  if (token >= GLFW_KEY_F1 && token <= GLFW_KEY_F12)
    return offset(KeyboardKey::kF1, token - GLFW_KEY_F1);
  if (token >= GLFW_KEY_KP_0 && token <= GLFW_KEY_KP_9) {
    return offset(KeyboardKey::kPad0, token - GLFW_KEY_KP_0);
  }
  const KeyboardKey byPrint = keyThatPrints(printed).value_or(KeyboardKey::kUnknown);
  if (token >= GLFW_KEY_0 && token <= GLFW_KEY_9) {
    return digitOf(byPrint) ? byPrint : offset(KeyboardKey::k0, token - GLFW_KEY_0);
  }
  if (byPrint != KeyboardKey::kUnknown) return byPrint;
  const bool letterPlace = token >= GLFW_KEY_A && token <= GLFW_KEY_Z;
  if (letterPlace && (printed.empty() || beyondAscii(printed))) {
    return offset(KeyboardKey::kA, token - GLFW_KEY_A);
  }
  return KeyboardKey::kUnknown;
}

}  // namespace vides
