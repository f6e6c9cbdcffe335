// SPDX-License-Identifier: MIT
// Names of keys and what they print.
#include "input/key.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace vides {
namespace {

// clang-format off
constexpr std::array<std::string_view, kKeyCount> kNames = {
  "unknown",
  "a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m",
  "n", "o", "p", "q", "r", "s", "t", "u", "v", "w", "x", "y", "z",
  "0", "1", "2", "3", "4", "5", "6", "7", "8", "9",
  "pad_0", "pad_1", "pad_2", "pad_3", "pad_4", "pad_5", "pad_6", "pad_7", "pad_8", "pad_9",
  "pad_decimal", "pad_divide", "pad_multiply", "pad_subtract", "pad_add", "pad_enter",
  "f1", "f2", "f3", "f4", "f5", "f6", "f7", "f8", "f9", "f10", "f11", "f12",
  "space", "escape", "enter", "tab", "backspace", "insert", "delete",
  "left", "right", "up", "down", "page_up", "page_down", "home", "end",
  "minus", "plus", "equal", "comma", "period", "slash", "backslash", "semicolon", "apostrophe",
  "left_bracket", "right_bracket", "grave_accent", "menu",
  "left_shift", "right_shift", "left_control", "right_control", "left_alt", "right_alt",
  "left_super", "right_super",
};
// clang-format on

struct Alias {
  std::string_view name;
  KeyboardKey key;
};
constexpr std::array kAliases = {
    Alias{"ctrl", KeyboardKey::kLeftControl}, Alias{"control", KeyboardKey::kLeftControl},
    Alias{"shift", KeyboardKey::kLeftShift},  Alias{"alt", KeyboardKey::kLeftAlt},
    Alias{"super", KeyboardKey::kLeftSuper},  Alias{"return", KeyboardKey::kEnter},
    Alias{"pageup", KeyboardKey::kPageUp},    Alias{"pagedown", KeyboardKey::kPageDown},
};

struct Sign {
  char character;
  KeyboardKey key;
};
constexpr std::array kSigns = {
    Sign{' ', KeyboardKey::kSpace},       Sign{'-', KeyboardKey::kMinus},
    Sign{'+', KeyboardKey::kPlus},        Sign{'=', KeyboardKey::kEqual},
    Sign{',', KeyboardKey::kComma},       Sign{'.', KeyboardKey::kPeriod},
    Sign{'/', KeyboardKey::kSlash},       Sign{'\\', KeyboardKey::kBackslash},
    Sign{';', KeyboardKey::kSemicolon},   Sign{'\'', KeyboardKey::kApostrophe},
    Sign{'[', KeyboardKey::kLeftBracket}, Sign{']', KeyboardKey::kRightBracket},
    Sign{'`', KeyboardKey::kGraveAccent},
};

KeyboardKey offset(KeyboardKey first, int steps) {
  return static_cast<KeyboardKey>(static_cast<int>(first) + steps);
}

}  // namespace

std::string_view keyName(KeyboardKey key) { return kNames[static_cast<std::size_t>(key)]; }

std::optional<KeyboardKey> keyFromName(std::string_view name) {
  std::string small(name);
  for (char& c : small) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  const auto found = std::find(kNames.begin() + 1, kNames.end(), small);
  if (found != kNames.end()) return static_cast<KeyboardKey>(found - kNames.begin());
  for (const Alias& alias : kAliases) {
    if (alias.name == small) return alias.key;
  }
  return std::nullopt;
}

std::optional<KeyboardKey> keyThatPrints(std::string_view character) {
  if (character.size() != 1) return std::nullopt;
  const char c = character.front();
  if (c >= 'a' && c <= 'z') return offset(KeyboardKey::kA, c - 'a');
  if (c >= 'A' && c <= 'Z') return offset(KeyboardKey::kA, c - 'A');
  if (c >= '0' && c <= '9') return offset(KeyboardKey::k0, c - '0');
  for (const Sign& sign : kSigns) {
    if (sign.character == c) return sign.key;
  }
  return std::nullopt;
}

std::optional<int> digitOf(KeyboardKey key) {
  if (key >= KeyboardKey::k0 && key <= KeyboardKey::k9)
    return static_cast<int>(key) - static_cast<int>(KeyboardKey::k0);
  if (key >= KeyboardKey::kPad0 && key <= KeyboardKey::kPad9) {
    return static_cast<int>(key) - static_cast<int>(KeyboardKey::kPad0);
  }
  return std::nullopt;
}

Modifiers modifierOf(KeyboardKey key) {
  Modifiers result;
  result.shift = key == KeyboardKey::kLeftShift || key == KeyboardKey::kRightShift;
  result.control = key == KeyboardKey::kLeftControl || key == KeyboardKey::kRightControl;
  result.alt = key == KeyboardKey::kLeftAlt || key == KeyboardKey::kRightAlt;
  result.super = key == KeyboardKey::kLeftSuper || key == KeyboardKey::kRightSuper;
  return result;
}

}  // namespace vides
