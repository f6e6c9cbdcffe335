// SPDX-License-Identifier: MIT
// Hours, minutes and seconds, split at the colons.
#include "edit/time_text.hpp"

#include <algorithm>

#include "edit/command.hpp"

namespace vides {

std::optional<double> parseTime(std::string_view text) {
  constexpr std::size_t kMostParts = 3;
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  if (!text.empty() && text.back() == 's') text.remove_suffix(1);
  double seconds = 0.0;
  for (std::size_t part = 0; part < kMostParts; ++part) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const auto number = parseNumber(text.substr(0, colon));
    const bool last = colon == text.size();
    if (!number || *number < 0.0 || (part > 0 && *number >= 60.0)) return std::nullopt;
    seconds = 60.0 * seconds + *number;
    if (last) return seconds;
    // Only the last part may have decimals.
    if (text.substr(0, colon).find_first_of(".,") != std::string_view::npos) return std::nullopt;
    text.remove_prefix(colon + 1);
  }
  return std::nullopt;
}

}  // namespace vides
