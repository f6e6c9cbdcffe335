// SPDX-License-Identifier: MIT
// From GLFW's keys, which are places on a US keyboard, to keys by what they print.
#pragma once

#include <string_view>

#include "input/key.hpp"

namespace vides {

// `token` is a GLFW_KEY_… value, `printed` what glfwGetKeyName says the key prints (UTF-8, may be
// empty). Keys that print nothing, the number pad's and space go by token. The row of digits gives
// digits even where they need Shift (French). Letters' places give the US letter where the layout
// prints a letter beyond ASCII there (Cyrillic).
KeyboardKey keyFromGlfw(int token, std::string_view printed);

}  // namespace vides
