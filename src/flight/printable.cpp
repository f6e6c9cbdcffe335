// SPDX-License-Identifier: MIT
// Puts the escapes in.
#include "flight/printable.hpp"

#include <fmt/format.h>

#include <iterator>

#include "flight/utf8.hpp"

namespace vides {
namespace {

void addBytes(std::string& out, std::string_view bytes) {
  for (const char c : bytes) {
    fmt::format_to(std::back_inserter(out), "\\x{:02X}",
                   static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
}

bool isControl(char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); }

// Looks like a blank, or like nothing at all.
bool isBlank(char32_t c) {
  return c == 0xA0 || c == 0xAD || c == 0x1680 || (c >= 0x2000 && c <= 0x200F) ||
         (c >= 0x2028 && c <= 0x202F) || (c >= 0x205F && c <= 0x206F) || c == 0x3000 || c == 0xFEFF;
}

// Calls back for each character: its bytes and number, number 0xFFFFFFFF for a byte of none.
template <class Each>
void forEachCharacter(std::string_view text, Each each) {
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    const std::string_view one = text.substr(0, length == 0 ? 1 : length);
    each(one, length == 0 ? char32_t{0xFFFFFFFF} : codePoint(one));
    text.remove_prefix(one.size());
  }
}

}  // namespace

std::string printable(std::string_view text) {
  std::string out;
  forEachCharacter(text, [&](std::string_view bytes, char32_t character) {
    const bool odd = character == 0xFFFFFFFF || isControl(character);
    odd ? addBytes(out, bytes) : static_cast<void>(out += bytes);
  });
  return out;
}

std::string unambiguous(std::string_view text, const std::function<bool(char32_t)>& hasGlyph) {
  std::string out;
  const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  std::size_t at = 0;
  forEachCharacter(text, [&](std::string_view bytes, char32_t character) {
    const bool atEnd = at < first || at > last;  // all of them where there are only blanks
    at += bytes.size();
    if (character == 0xFFFFFFFF || isControl(character) || (character == ' ' && atEnd)) {
      addBytes(out, bytes);
    } else if (character == '\\') {
      out += "\\\\";
    } else if (isBlank(character) || !hasGlyph(character)) {
      fmt::format_to(std::back_inserter(out), "\\u{{{:x}}}", static_cast<unsigned>(character));
    } else {
      out += bytes;
    }
  });
  return out;
}

}  // namespace vides
