// SPDX-License-Identifier: MIT
// Characters as UTF-8.
#include "input/input_event.hpp"

namespace vides {

std::string utf8(char32_t character) {
  const bool surrogate = character >= 0xD800 && character <= 0xDFFF;
  if (surrogate || character > 0x10FFFF) return {};
  const auto tail = [character](int shift) {
    return static_cast<char>(0x80 | ((character >> shift) & 0x3F));
  };
  if (character < 0x80) return {static_cast<char>(character)};
  if (character < 0x800) return {static_cast<char>(0xC0 | (character >> 6)), tail(0)};
  if (character < 0x10000) {
    return {static_cast<char>(0xE0 | (character >> 12)), tail(6), tail(0)};
  }
  return {static_cast<char>(0xF0 | (character >> 18)), tail(12), tail(6), tail(0)};
}

}  // namespace vides
