// SPDX-License-Identifier: MIT
// Text that is somebody else's, names of files above all: any bytes, shown on one line.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace vides {

// For messages and terminals: `\xHH` stands for each byte below 0x20, 0x7F, or that isn't UTF-8
// (and of control characters beyond ASCII, which terminals obey too). What is UTF-8 without control
// characters stays as it is.
std::string printable(std::string_view text);

// For lists, where each name is told from every other: also `\\` for a backslash, `\u{…}` for a
// character without a glyph or one that looks like a blank or like nothing, and `\x20` for a blank
// at an end.
std::string unambiguous(std::string_view text, const std::function<bool(char32_t)>& hasGlyph);

}  // namespace vides
