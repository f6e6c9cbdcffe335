// SPDX-License-Identifier: MIT
// A picture's size as it is typed.
#pragma once

#include <optional>
#include <string_view>

namespace vides {

inline constexpr int kMostPixels = 16384;  // along a side

struct TypedSize {
  int width = 0;              // pixels
  std::optional<int> height;  // nothing: as the picture's format has it
  bool operator==(const TypedSize&) const = default;
};

// "1280x800": width and height in pixels, 1 to kMostPixels each; "1280": the width alone. Nothing
// for other text.
std::optional<TypedSize> parsePictureSize(std::string_view text);

}  // namespace vides
