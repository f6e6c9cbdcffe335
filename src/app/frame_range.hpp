// SPDX-License-Identifier: MIT
// Frame numbers and ranges as they are typed.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace vides {

// A whole number of at most 12 digits, with or without a sign.
std::optional<std::int64_t> parseFrameNumber(std::string_view text);

// Frames first <= n < last.
struct FrameRange {
  std::int64_t first = 0;
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
};
// "A:B", "A:", ":B" or ":", with 0 <= A < B; or a sentence about what is wrong.
tl::expected<FrameRange, std::string> parseFrameRange(std::string_view text);

}  // namespace vides
