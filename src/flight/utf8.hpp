// SPDX-License-Identifier: MIT
// Well-formed UTF-8 (Unicode 15, table 3-7): no overlong forms, no surrogates, nothing beyond
// U+10FFFF.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace vides {

// The bytes of the code point that begins the text, 1 to 4; 0 if there is none or it is ill-formed.
std::size_t utf8Length(std::string_view text);

// The code point of a well-formed sequence of utf8Length() bytes.
char32_t codePoint(std::string_view one);

// Number of code points; nothing if the text isn't UTF-8.
std::optional<std::size_t> codePoints(std::string_view text);

}  // namespace vides
