// SPDX-License-Identifier: MIT
// Makes words of files fit for messages.
#include "scene/scene_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "flight/utf8.hpp"

namespace vides {

std::string shownWord(std::string_view word) {
  constexpr std::size_t kMost = 32;  // bytes
  std::string shown;
  for (std::string_view rest = word; !rest.empty();) {
    const std::size_t length = utf8Length(rest);
    const auto byte = static_cast<unsigned char>(rest.front());
    if (word.size() - rest.size() + std::max<std::size_t>(length, 1) > kMost) return shown + "...";
    if (length == 0 || byte < 0x20 || byte == 0x7f) {
      fmt::format_to(std::back_inserter(shown), "\\x{:02x}", byte);
    } else {
      shown += rest.substr(0, length);
    }
    rest.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return shown;
}

}  // namespace vides
