// SPDX-License-Identifier: MIT
// What fuzz targets share: the input as text, and promises that end the run where they don't hold.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace vides::test {

inline std::string_view asText(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// The first line, which leaves the text.
inline std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

inline void require(bool condition, std::string_view what) {
  if (condition) return;
  fmt::print(stderr, "broken promise: {}\n", what);
  std::abort();
}

}  // namespace vides::test
