// SPDX-License-Identifier: MIT
// The menus, and at their right the output line and the flight's name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/ui.hpp"

namespace vides {

// An entry of a menu: an identifier `menu/MENU/NAME`, and the line of the command that it runs.
struct MenuEntry {
  std::string id;
  std::string command;
};
struct Menu {
  std::string id;                  // "menu/file"
  std::vector<MenuEntry> entries;  // an entry without identifier is a line between two groups
};
// All of them, in their order: the menu bar and the list of widgets are made from it.
const std::vector<Menu>& menus();

// Inside a window's menu bar.
float menuBar(Ui& ui, const Session& session, const OutputLine& output, const Layout& layout,
              Actions& actions);

}  // namespace vides
