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

struct WindowFrame {
  const char* id;
  float width, height;  // at content scale 1; less where the screen is smaller
  std::string heading;
  bool focus = true;   // takes the keyboard; only the top window may
  bool modal = false;  // nothing under it can be reached
  bool wraps = false;  // the heading takes as many lines as it needs, and the window grows by them
  // What its content can do with, at content scale 1; 0: with nothing less than the frame's size.
  // On a smaller screen the content is scrolled.
  float leastWidth = 0.0f, leastHeight = 0.0f;
};

// The lines of a text, broken at blanks, and inside words that are longer than a line.
std::vector<std::string> wrapped(const Ui& ui, std::string_view text, float width,
                                 Weight weight = Weight::kRegular);

// In the middle of the screen, with a heading; `content` draws into what is left.
void windowFrame(Ui& ui, const WindowFrame& frame, const std::function<void(const Rect&)>& content);

// Where a window stands that the user can move by its heading; kept between display frames.
struct WindowPlace {
  bool moved = false;        // by the user; else where the frame wants it
  float x = 0.0f, y = 0.0f;  // pixels
  bool dragging = false;
  float gripX = 0.0f, gripY = 0.0f;  // from its corner to the pointer at the press
};

struct FloatingFrame {
  std::string area;     // "shape": its heading is the area shape/heading
  float width, height;  // at content scale 1; less where the screen is smaller
  std::string heading;
  // Pixels: where it stands until it is moved, kept on the screen; absent: in the middle.
  std::optional<float> x = {}, y = {};
  float leastWidth = 0.0f, leastHeight = 0.0f;  // as in WindowFrame
};

// Over the editor, which can be used on beside it. False if its close button was pressed.
bool floatingFrame(Ui& ui, const FloatingFrame& frame, WindowPlace& place,
                   const std::function<void(const Rect&)>& content);

}  // namespace vides
