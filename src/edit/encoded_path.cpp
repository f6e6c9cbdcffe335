// SPDX-License-Identifier: MIT
// Bytes as %XX and back.
#include "edit/encoded_path.hpp"

#include <fmt/format.h>

namespace vides {
namespace {

// The number of a digit of sixteen; nothing for other characters.
std::optional<unsigned> hexDigit(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A') + 10;
  return std::nullopt;
}

}  // namespace

std::string encodedPath(const std::string& path) {
  std::string out;
  for (const char c : path) {
    const bool plain = c > ' ' && c < 0x7f && c != '"' && c != '\\' && c != '%';
    if (plain) {
      out += c;
    } else {
      out += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
  }
  return out;
}

std::optional<std::string> decodedPath(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    if (c == '%') {
      if (i + 2 >= text.size()) return std::nullopt;
      const auto high = hexDigit(text[i + 1]), low = hexDigit(text[i + 2]);
      if (!high || !low) return std::nullopt;
      c = static_cast<char>(*high * 16 + *low);
      i += 2;
    } else if (c == '"' || c == '\\') {
      return std::nullopt;
    }
    if (c == '\0') return std::nullopt;
    out += c;
  }
  return out;
}

}  // namespace vides
