// SPDX-License-Identifier: MIT
// What the open menu keeps between display frames, and what keys do in it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "input/input_event.hpp"
#include "panels/widget_registry.hpp"

namespace vides {

class MenuMemory {
 public:
  static constexpr int kFirst = -2;  // marked is the first row that can be chosen
  struct Row {
    std::string id, label;
    bool enabled = true;
    bool opens = false;  // a further menu
  };
  // A menu that is open, of the last display frame.
  struct Level {
    std::vector<Row> rows;
    int marked = -1;  // by keys or the pointer
    Rect rect;        // on screen
  };

  // Keys go by what they print. Each of them is the menu's, whether it means something or not.
  void key(const KeyChanged& change);
  // A character that no key event stood for.
  void typed(std::string_view text);
  // Whether a press there is the menu's; else it closes the menu and does what it does.
  bool holds(float x, float y) const;
  // Another menu is open now, or none.
  void opened(std::string_view menu);

  std::string shown;  // the menu that is open
  Level main, further;
  bool furtherOpen = false;
  bool byPointer = false;  // opened by it: no row is marked
  bool byHover = false;    // opened by moving from another one: a press on its name leaves it open
  Rect bar;
  unsigned focusBefore = 0;  // the window that had the keyboard

  // What keys ask for, taken by the menu bar.
  bool operates = false;
  bool closes = false;
  int neighbour = 0;  // the next menu (1), the one before (-1)
  bool reveals = false;

 private:
  Level& top() { return furtherOpen ? further : main; }
  void mark(int step);
  void markLetter(std::string_view letter);
  std::string lettered_;  // a letter that its key has dealt with: its text follows
};

}  // namespace vides
