// SPDX-License-Identifier: MIT
// Checks the bytes of UTF-8.
#include "flight/utf8.hpp"

namespace vides {

std::size_t utf8Length(std::string_view text) {
  const auto byte = [&](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u;
  };
  if (text.empty()) return 0;
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead < 0xC2 || lead > 0xF4) return 0;
  // The second byte's range is narrower after some first bytes.
  const unsigned low = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
  const unsigned high = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
  if (byte(1) < low || byte(1) > high) return 0;
  const std::size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  for (std::size_t k = 2; k < length; ++k) {
    if (byte(k) < 0x80 || byte(k) > 0xBF) return 0;
  }
  return length;
}

char32_t codePoint(std::string_view one) {
  const auto byte = [&](std::size_t k) {
    return static_cast<char32_t>(static_cast<unsigned char>(one[k]));
  };
  constexpr char32_t kFirst[] = {0x7F, 0x1F, 0x0F, 0x07};  // bits of the first byte
  char32_t result = byte(0) & kFirst[one.size() - 1];
  for (std::size_t k = 1; k < one.size(); ++k) result = result << 6 | (byte(k) & 0x3F);
  return result;
}

std::optional<std::size_t> codePoints(std::string_view text) {
  std::size_t count = 0;
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    if (length == 0) return std::nullopt;
    text.remove_prefix(length);
    ++count;
  }
  return count;
}

}  // namespace vides
