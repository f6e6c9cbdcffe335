// SPDX-License-Identifier: MIT
// Every widget that the editor has, also in closed menus and windows.
#pragma once

#include <map>
#include <string>

#include "app/drive/player.hpp"

namespace vides {

// Identifiers and their labels in the current language. Opens and closes every window.
std::map<std::string, std::string> allWidgets(Player& player);

}  // namespace vides
