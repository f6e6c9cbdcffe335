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
  Key key;
};
constexpr std::array kAliases = {
    Alias{"ctrl", Key::kLeftControl}, Alias{"control", Key::kLeftControl},
    Alias{"shift", Key::kLeftShift},  Alias{"alt", Key::kLeftAlt},
    Alias{"super", Key::kLeftSuper},  Alias{"return", Key::kEnter},
    Alias{"pageup", Key::kPageUp},    Alias{"pagedown", Key::kPageDown},
};

struct Sign {
  char character;
  Key key;
};
constexpr std::array kSigns = {
    Sign{' ', Key::kSpace},       Sign{'-', Key::kMinus},       Sign{'+', Key::kPlus},
    Sign{'=', Key::kEqual},       Sign{',', Key::kComma},       Sign{'.', Key::kPeriod},
    Sign{'/', Key::kSlash},       Sign{'\\', Key::kBackslash},  Sign{';', Key::kSemicolon},
    Sign{'\'', Key::kApostrophe}, Sign{'[', Key::kLeftBracket}, Sign{']', Key::kRightBracket},
    Sign{'`', Key::kGraveAccent},
};

Key offset(Key first, int steps) { return static_cast<Key>(static_cast<int>(first) + steps); }

}  // namespace

std::string_view keyName(Key key) { return kNames[static_cast<std::size_t>(key)]; }

std::optional<Key> keyFromName(std::string_view name) {
  std::string small(name);
  for (char& c : small) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  const auto found = std::find(kNames.begin() + 1, kNames.end(), small);
  if (found != kNames.end()) return static_cast<Key>(found - kNames.begin());
  for (const Alias& alias : kAliases) {
    if (alias.name == small) return alias.key;
  }
  return std::nullopt;
}

std::optional<Key> keyThatPrints(std::string_view character) {
  if (character.size() != 1) return std::nullopt;
  const char c = character.front();
  if (c >= 'a' && c <= 'z') return offset(Key::kA, c - 'a');
  if (c >= 'A' && c <= 'Z') return offset(Key::kA, c - 'A');
  if (c >= '0' && c <= '9') return offset(Key::k0, c - '0');
  for (const Sign& sign : kSigns) {
    if (sign.character == c) return sign.key;
  }
  return std::nullopt;
}

std::optional<int> digitOf(Key key) {
  if (key >= Key::k0 && key <= Key::k9) return static_cast<int>(key) - static_cast<int>(Key::k0);
  if (key >= Key::kPad0 && key <= Key::kPad9) {
    return static_cast<int>(key) - static_cast<int>(Key::kPad0);
  }
  return std::nullopt;
}

Modifiers modifierOf(Key key) {
  Modifiers result;
  result.shift = key == Key::kLeftShift || key == Key::kRightShift;
  result.control = key == Key::kLeftControl || key == Key::kRightControl;
  result.alt = key == Key::kLeftAlt || key == Key::kRightAlt;
  result.super = key == Key::kLeftSuper || key == Key::kRightSuper;
  return result;
}

}  // namespace vides
