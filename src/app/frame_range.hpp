// SPDX-License-Identifier: MIT
// Frame numbers and ranges as they are typed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "io/frame_writer.hpp"

namespace vides {

// A whole number of at most 12 digits, with or without a sign.
std::optional<std::int64_t> parseFrameNumber(std::string_view text);

// "A:B", "A:", ":B" or ":", with 0 <= A < B; or a sentence about what is wrong.
tl::expected<FrameRange, std::string> parseFrameRange(std::string_view text);

}  // namespace vides
