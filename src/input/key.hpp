// SPDX-License-Identifier: MIT
// The keyboard's keys and modifiers, named as in the scripts of `vides drive`. (`Key` alone is a
// position of the flight.)
//
// A key that prints a letter, digit or sign goes by what it prints, not by where it lies: kZ is
// where Z is printed. Where the layout prints no Latin letter (Greek, Cyrillic) it goes by its
// place on a US keyboard, so that Ctrl+Z works there, too.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace vides {

// clang-format off
enum class KeyboardKey : std::uint8_t {
  kUnknown,
  kA, kB, kC, kD, kE, kF, kG, kH, kI, kJ, kK, kL, kM,
  kN, kO, kP, kQ, kR, kS, kT, kU, kV, kW, kX, kY, kZ,
  k0, k1, k2, k3, k4, k5, k6, k7, k8, k9,
  kPad0, kPad1, kPad2, kPad3, kPad4, kPad5, kPad6, kPad7, kPad8, kPad9,
  kPadDecimal, kPadDivide, kPadMultiply, kPadSubtract, kPadAdd, kPadEnter,
  kF1, kF2, kF3, kF4, kF5, kF6, kF7, kF8, kF9, kF10, kF11, kF12,
  kSpace, kEscape, kEnter, kTab, kBackspace, kInsert, kDelete,
  kLeft, kRight, kUp, kDown, kPageUp, kPageDown, kHome, kEnd,
  kMinus, kPlus, kEqual, kComma, kPeriod, kSlash, kBackslash, kSemicolon, kApostrophe,
  kLeftBracket, kRightBracket, kGraveAccent, kMenu,
  kLeftShift, kRightShift, kLeftControl, kRightControl, kLeftAlt, kRightAlt, kLeftSuper, kRightSuper,
};
// clang-format on
inline constexpr int kKeyCount = static_cast<int>(KeyboardKey::kRightSuper) + 1;

struct Modifiers {
  bool shift = false;
  bool control = false;
  bool alt = false;
  bool super = false;
  bool operator==(const Modifiers&) const = default;
};

// "z", "7", "pad_7", "page_up", "f1", "left_shift"; "unknown" for kUnknown.
std::string_view keyName(KeyboardKey key);

// The key of that name, capital or small; nothing for other text. "ctrl", "shift", "alt" and
// "super" are the left ones, "return" is enter.
std::optional<KeyboardKey> keyFromName(std::string_view name);

// The key that prints this one character (UTF-8): letters of both cases, digits, signs.
std::optional<KeyboardKey> keyThatPrints(std::string_view character);

// The digit on a key of the row or the number pad.
std::optional<int> digitOf(KeyboardKey key);

// The modifier that a key stands for, set in the result; none for other keys.
Modifiers modifierOf(KeyboardKey key);

}  // namespace vides
