// SPDX-License-Identifier: MIT
// No sscanf: everything must be read, and nothing may overflow.
#include "app/frame_range.hpp"

#include <fmt/format.h>

#include <charconv>
#include <limits>

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

namespace {

// An end of a range is clipped to the flight, however large it is: of digits alone every number is
// one.
std::optional<std::int64_t> parseEnd(std::string_view text) {
  if (text.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc::result_out_of_range) return std::numeric_limits<std::int64_t>::max();
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

}  // namespace

tl::expected<FrameRange, std::string> parseFrameRange(std::string_view text) {
  const auto refuse = [&](std::string_view why) {
    return tl::unexpected(fmt::format("'{}' {}", text, why));
  };
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return refuse("is not of the form A:B");
  FrameRange range;
  if (const auto part = text.substr(0, colon); !part.empty()) {
    const auto first = parseEnd(part);
    if (!first) return refuse("does not begin with a frame number");
    range.first = *first;
  }
  if (const auto part = text.substr(colon + 1); !part.empty()) {
    const auto last = parseEnd(part);
    if (!last) return refuse("does not end with a frame number");
    range.last = *last;
  }
  if (range.first >= range.last) return refuse("is empty: A:B takes frames A <= n < B");
  return range;
}

}  // namespace vides
