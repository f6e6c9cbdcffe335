// SPDX-License-Identifier: MIT
// The one table of shortcuts: what keys do, menus' hints, the help and the tests are made from it.
//
// Keys go by what they print (input/key.hpp); digits of the number pad count as digits. Whoever
// asks makes sure that no text is being typed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edit/command.hpp"
#include "edit/texts.hpp"
#include "input/key.hpp"

namespace vides {

struct Shortcut {
  KeyboardKey key = KeyboardKey::kUnknown;
  Modifiers modifiers;
  Command command;
  std::string group;     // of the help: "file", "keys", …; its title is "shortcuts.GROUP"
  bool repeats = false;  // again and again while the key is held
  // While a text is being typed it is committed first; all others are the text's then.
  bool commitsTyping = false;
};

const std::vector<Shortcut>& shortcutTable();

// Null where the keys do nothing. A key that repeats only finds what may repeat.
const Shortcut* shortcutFor(KeyboardKey key, const Modifiers& modifiers, bool repeated = false);
// The first shortcut of a command with these arguments (or of the name alone); null without one.
const Shortcut* shortcutOf(const Command& command);

// "Ctrl+Shift+Z" in the language of the texts, for menus, tooltips and the help.
std::string shown(const Shortcut& shortcut, const Texts& texts);
// "ctrl+shift+z", as in scripts.
std::string scriptName(const Shortcut& shortcut);
// What it does, in words: the command's title, or that of the command with its argument.
Text titleOf(const Command& command, const Texts& texts);

}  // namespace vides
