// SPDX-License-Identifier: MIT
// How a text is encoded that another program may have written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vides {

enum class TextEncoding : std::uint8_t { kUtf8, kUtf16Little, kUtf16Big, kUtf32 };

// By the byte order mark; without one UTF-16 is known by a NUL beside each of the first two
// characters, which no UTF-8 text of ours has.
TextEncoding encodingOf(std::string_view text);
// "UTF-16" and so on.
const char* name(TextEncoding encoding);

// Behind a UTF-8 byte order mark, if there is one.
std::string_view withoutByteOrderMark(std::string_view text);

// UTF-16 of that byte order as UTF-8, without the mark. Nothing where it isn't whole.
std::optional<std::string> utf8FromUtf16(std::string_view text, TextEncoding order);

// How many lines a text has begun before its end: they end with CR, LF or CRLF.
std::int64_t lineEnds(std::string_view text);

}  // namespace vides
