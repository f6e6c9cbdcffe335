// SPDX-License-Identifier: MIT
// What windows over the editor have in common: place, heading, the shade under one that is modal.
#pragma once

#include <functional>
#include <string>

#include "panels/ui.hpp"

namespace vides {

struct WindowFrame {
  const char* id;
  float width, height;  // at content scale 1; less where the screen is smaller
  std::string heading;
  bool focus = true;   // takes the keyboard; only the top window may
  bool modal = false;  // nothing under it can be reached
};

// In the middle of the screen, with a heading; `content` draws into what is left.
void windowFrame(Ui& ui, const WindowFrame& frame, const std::function<void(const Rect&)>& content);

}  // namespace vides
