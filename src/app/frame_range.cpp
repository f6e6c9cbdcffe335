// SPDX-License-Identifier: MIT
// No sscanf: everything must be read, and nothing may overflow.
#include "app/frame_range.hpp"

#include <fmt/format.h>

#include <charconv>

namespace vides {

std::optional<std::int64_t> parseFrameNumber(std::string_view text) {
  const bool plus = text.starts_with('+');
  if (plus) text.remove_prefix(1);
  const std::string_view digits = text.starts_with('-') ? text.substr(1) : text;
  if (digits.size() > 12 || (plus && digits.size() != text.size())) return std::nullopt;
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

tl::expected<FrameRange, std::string> parseFrameRange(std::string_view text) {
  const auto refuse = [&](std::string_view why) {
    return tl::unexpected(fmt::format("'{}' {}", text, why));
  };
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return refuse("is not of the form A:B");
  FrameRange range;
  if (const auto part = text.substr(0, colon); !part.empty()) {
    const auto first = parseFrameNumber(part);
    if (!first || *first < 0) return refuse("does not begin with a frame number");
    range.first = *first;
  }
  if (const auto part = text.substr(colon + 1); !part.empty()) {
    const auto last = parseFrameNumber(part);
    if (!last || *last < 0) return refuse("does not end with a frame number");
    range.last = *last;
  }
  if (range.first >= range.last) return refuse("is empty: A:B takes frames A <= n < B");
  return range;
}

}  // namespace vides
