// SPDX-License-Identifier: MIT
// Every widget that the editor has, also in closed menus and windows.
#pragma once

#include <map>
#include <string>

#include "app/drive/player.hpp"

namespace vides {

// By identifier, labels in the current language. Opens and closes every window.
std::map<std::string, Widget> allWidgets(Player& player);

}  // namespace vides
