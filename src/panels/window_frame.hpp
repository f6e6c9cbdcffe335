// SPDX-License-Identifier: MIT
// What windows over the editor have in common: place, heading, the shade under one that is modal.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "panels/ui.hpp"

namespace vides {

// Draws into the room that it is given.
using FramePart = std::function<void(const Rect&)>;

struct WindowFrame {
  const char* id;
  float width, height;  // at content scale 1; less where the work area is smaller
  std::string heading;
  bool focus = true;   // takes the keyboard; only the top window may
  bool modal = false;  // nothing under it can be reached
  // The heading takes as many lines as it needs, and the window grows by them and by those below.
  bool wraps = false;
  // What its content can do with, at content scale 1; 0: with nothing less than the frame's size.
  // In a smaller work area the content is scrolled.
  float leastWidth = 0.0f, leastHeight = 0.0f;
  std::string detail = {};  // under a heading that wraps, in the secondary colour
  std::string close = {};   // identifier of the button at the heading's right; empty: none
};

// Height of the row of buttons at a window's end, at content scale 1, and the gap above it.
inline constexpr float kWindowButtons = 26.0f;
inline constexpr float kAboveWindowButtons = 12.0f;
inline constexpr float kLastButton = 110.0f;  // width of one, where there is room

// Places for buttons at the right end of that row, from left to right. The last is for the one that
// confirms, the one before it for Cancel.
std::vector<Rect> lastButtons(const Ui& ui, const Rect& row, int count);

// The lines of a text, broken at blanks, and inside words that are longer than a line.
std::vector<std::string> wrapped(const Ui& ui, std::string_view text, float width,
                                 Weight weight = Weight::kRegular);

// In the middle of the work area, with a heading; `buttons` draws the row at its end, which stays
// in sight however small the window is, `content` what is between. False if it was closed.
bool windowFrame(Ui& ui, const WindowFrame& frame, const FramePart& content,
                 const FramePart& buttons = {});

// Where a window stands that the user can move by its heading; kept between display frames.
struct WindowPlace {
  bool moved = false;        // by the user; else where the frame wants it
  float x = 0.0f, y = 0.0f;  // pixels
  bool dragging = false;
  float gripX = 0.0f, gripY = 0.0f;  // from its corner to the pointer at the press
};

struct FloatingFrame {
  std::string area;     // "shape": its heading is the area shape/heading
  float width, height;  // at content scale 1; less where the work area is smaller
  std::string heading;
  // Pixels: where it stands until it is moved, kept in the work area; absent: in the middle.
  std::optional<float> x = {}, y = {};
  float leastWidth = 0.0f, leastHeight = 0.0f;  // as in WindowFrame
};

// Over the editor, which can be used on beside it. False if its close button was pressed.
bool floatingFrame(Ui& ui, const FloatingFrame& frame, WindowPlace& place, const FramePart& content,
                   const FramePart& buttons = {});

}  // namespace vides
