// SPDX-License-Identifier: MIT
// From GLFW's keys to keys by what they print.
#include "host/glfw_keys.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>

namespace vides {
namespace {

Key offset(Key first, int steps) { return static_cast<Key>(static_cast<int>(first) + steps); }

struct Row {
  int token;
  Key key;
};
constexpr std::array kKeys = {
    Row{GLFW_KEY_SPACE, Key::kSpace},
    Row{GLFW_KEY_ESCAPE, Key::kEscape},
    Row{GLFW_KEY_ENTER, Key::kEnter},
    Row{GLFW_KEY_TAB, Key::kTab},
    Row{GLFW_KEY_BACKSPACE, Key::kBackspace},
    Row{GLFW_KEY_INSERT, Key::kInsert},
    Row{GLFW_KEY_DELETE, Key::kDelete},
    Row{GLFW_KEY_LEFT, Key::kLeft},
    Row{GLFW_KEY_RIGHT, Key::kRight},
    Row{GLFW_KEY_UP, Key::kUp},
    Row{GLFW_KEY_DOWN, Key::kDown},
    Row{GLFW_KEY_PAGE_UP, Key::kPageUp},
    Row{GLFW_KEY_PAGE_DOWN, Key::kPageDown},
    Row{GLFW_KEY_HOME, Key::kHome},
    Row{GLFW_KEY_END, Key::kEnd},
    Row{GLFW_KEY_MENU, Key::kMenu},
    Row{GLFW_KEY_KP_DECIMAL, Key::kPadDecimal},
    Row{GLFW_KEY_KP_DIVIDE, Key::kPadDivide},
    Row{GLFW_KEY_KP_MULTIPLY, Key::kPadMultiply},
    Row{GLFW_KEY_KP_SUBTRACT, Key::kPadSubtract},
    Row{GLFW_KEY_KP_ADD, Key::kPadAdd},
    Row{GLFW_KEY_KP_ENTER, Key::kPadEnter},
    Row{GLFW_KEY_KP_EQUAL, Key::kEqual},
    Row{GLFW_KEY_LEFT_SHIFT, Key::kLeftShift},
    Row{GLFW_KEY_RIGHT_SHIFT, Key::kRightShift},
    Row{GLFW_KEY_LEFT_CONTROL, Key::kLeftControl},
    Row{GLFW_KEY_RIGHT_CONTROL, Key::kRightControl},
    Row{GLFW_KEY_LEFT_ALT, Key::kLeftAlt},
    Row{GLFW_KEY_RIGHT_ALT, Key::kRightAlt},
    Row{GLFW_KEY_LEFT_SUPER, Key::kLeftSuper},
    Row{GLFW_KEY_RIGHT_SUPER, Key::kRightSuper},
};

bool beyondAscii(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
}

}  // namespace

Key keyFromGlfw(int token, std::string_view printed) {
  for (const Row& row : kKeys) {
    if (row.token == token) return row.key;
  }
  if (token >= GLFW_KEY_F1 && token <= GLFW_KEY_F12) return offset(Key::kF1, token - GLFW_KEY_F1);
  if (token >= GLFW_KEY_KP_0 && token <= GLFW_KEY_KP_9) {
    return offset(Key::kPad0, token - GLFW_KEY_KP_0);
  }
  const Key byPrint = keyThatPrints(printed).value_or(Key::kUnknown);
  if (token >= GLFW_KEY_0 && token <= GLFW_KEY_9) {
    return digitOf(byPrint) ? byPrint : offset(Key::k0, token - GLFW_KEY_0);
  }
  if (byPrint != Key::kUnknown) return byPrint;
  const bool letterPlace = token >= GLFW_KEY_A && token <= GLFW_KEY_Z;
  if (letterPlace && (printed.empty() || beyondAscii(printed))) {
    return offset(Key::kA, token - GLFW_KEY_A);
  }
  return Key::kUnknown;
}

}  // namespace vides
