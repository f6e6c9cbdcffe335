// SPDX-License-Identifier: MIT
// A picture's size as it is typed.
#pragma once

#include <optional>
#include <string_view>
#include <utility>

namespace vides {

// "1280x800": width and height in pixels, 1 to 16,384; nothing for other text.
std::optional<std::pair<int, int>> parsePictureSize(std::string_view text);

}  // namespace vides
