// SPDX-License-Identifier: MIT
// A time as a user types it.
#pragma once

#include <optional>
#include <string_view>

namespace vides {

// Seconds from "12.5", "12,5 s", "1:04.52" or "1:02:03"; nothing for other text and below 0. All
// parts but the first are below 60.
std::optional<double> parseTime(std::string_view text);

}  // namespace vides
