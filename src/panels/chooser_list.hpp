// SPDX-License-Identifier: MIT
// The file chooser's list: names, sizes and dates, sorted by a click on a column's head.
#pragma once

#include "panels/chooser.hpp"
#include "panels/ui.hpp"

namespace vides {

// What a click in the list asks for.
struct ChooserClick {
  int entry = -1;      // to be chosen; -1: none
  bool twice = false;  // and taken at once
};
// Draws the folder's entries and sorts them anew where that is asked for.
ChooserClick chooserList(Ui& ui, const Rect& all, ChooserMemory& memory);

}  // namespace vides
