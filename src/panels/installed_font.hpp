// SPDX-License-Identifier: MIT
// Fonts of this machine for characters that our typeface has no sign for.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace vides {

struct InstalledFont {
  std::string bytes;              // of the file
  int number = 0;                 // of the font in it
  std::set<char32_t> characters;  // of those asked for, what it has signs for
};

// One font or several that together have signs for as many of the characters as can be had, found
// by fontconfig where that is installed. Each character is in one of them at most.
std::vector<InstalledFont> installedFontsFor(std::set<char32_t> characters);

}  // namespace vides
