// SPDX-License-Identifier: MIT
// The pieces of text that a Problem is made of.
#include "flight/problem.hpp"

namespace vides {
namespace {

constexpr std::size_t kMostFoundBytes = 60;
constexpr std::size_t kMostTokenBytes = 120;

// Cuts before the code point that no longer fits.
std::string cut(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return std::string(text.substr(0, end)) + "…";
}

}  // namespace

std::string shortened(std::string_view text) { return cut(text, kMostFoundBytes); }

std::string pointerToken(std::string_view name) {
  std::string token = "/";
  for (const char c : cut(name, kMostTokenBytes)) {
    if (c == '~') {
      token += "~0";
    } else if (c == '/') {
      token += "~1";
    } else {
      token += c;
    }
  }
  return token;
}

}  // namespace vides
