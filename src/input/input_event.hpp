// SPDX-License-Identifier: MIT
// What the user does, as values: a host fills a queue of these, `vides drive` fills it itself.
//
// Places are in pixels of the picture that is drawn (not in a window system's own units), from its
// upper left corner, x to the right, y down, with decimals where the pointer has them.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "input/key.hpp"

namespace vides {

// A size in pixels; 0 × 0 is a window that is minimised.
struct PixelSize {
  int width = 0;
  int height = 0;
  bool empty() const { return width < 1 || height < 1; }
  bool operator==(const PixelSize&) const = default;
};

enum class PointerButton : std::uint8_t { kLeft, kMiddle, kRight };

struct PointerMoved {
  double x = 0.0;
  double y = 0.0;
  bool operator==(const PointerMoved&) const = default;
};

// The pointer left the window: nothing is under it until it moves again.
struct PointerLeft {
  bool operator==(const PointerLeft&) const = default;
};

struct ButtonChanged {
  PointerButton button = PointerButton::kLeft;
  bool pressed = false;
  Modifiers modifiers;
  bool operator==(const ButtonChanged&) const = default;
};

// Steps of the wheel: positive y is away from the user, positive x to the right.
struct WheelTurned {
  double x = 0.0;
  double y = 0.0;
  bool operator==(const WheelTurned&) const = default;
};

// `modifiers` are those held after the change: pressing left_shift has shift, releasing it has not.
struct KeyChanged {
  KeyboardKey key = KeyboardKey::kUnknown;
  bool pressed = false;
  bool repeated = false;  // pressed again by being held
  Modifiers modifiers;
  bool operator==(const KeyChanged&) const = default;
};

struct TextTyped {
  std::string text;  // UTF-8, at least one character
  bool operator==(const TextTyped&) const = default;
};

struct FilesDropped {
  std::vector<std::string> paths;
  bool operator==(const FilesDropped&) const = default;
};

struct Resized {
  PixelSize size;
  double contentScale = 1.0;  // how much larger than at 96 dots an inch widgets are drawn
  bool operator==(const Resized&) const = default;
};

struct FocusChanged {
  bool focused = false;
  bool operator==(const FocusChanged&) const = default;
};

// The window's picture was lost and must be drawn again.
struct Exposed {
  bool operator==(const Exposed&) const = default;
};

// The user wants the window closed; it closes only if the program ends.
struct CloseRequested {
  bool operator==(const CloseRequested&) const = default;
};

using InputEvent =
    std::variant<PointerMoved, PointerLeft, ButtonChanged, WheelTurned, KeyChanged, TextTyped,
                 FilesDropped, Resized, FocusChanged, Exposed, CloseRequested>;

// The character as UTF-8; empty for what is no character (a surrogate, beyond U+10FFFF).
std::string utf8(char32_t character);

}  // namespace vides
