// SPDX-License-Identifier: MIT
// What stands in the menus: one table, and its rows as they are now.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edit/session.hpp"
#include "panels/actions.hpp"
#include "panels/menu_memory.hpp"
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

// A row as it is drawn, and what it does.
struct MenuItem {
  MenuMemory::Row row;  // empty identifier: a line between groups
  Ui::MenuRow style = {};
  std::string command = {};            // its line; empty where it folds a part of the window
  std::optional<Command> recent = {};  // opens this file
};
std::vector<MenuItem> itemsOf(const Ui& ui, const Menu& menu, const Session& session,
                              const Layout& layout);
std::vector<MenuItem> recentItems(Ui& ui, const Session& session);

// What it does, and the menu closes.
void choose(const MenuItem& item, const Layout& layout, Actions& actions);

}  // namespace vides
