// SPDX-License-Identifier: MIT
// A colour as it is stored and blended: plain sRGB bytes, straight alpha.
#pragma once

#include <cstdint>

namespace vides {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
  bool operator==(const Colour&) const = default;
};

inline constexpr Colour kNoColour{0, 0, 0, 0};

// 0xRRGGBB, opaque.
constexpr Colour colour(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16 & 0xff), static_cast<std::uint8_t>(rgb >> 8 & 0xff),
          static_cast<std::uint8_t>(rgb & 0xff), 255};
}

// From `a` (share 0) to `b` (share 1), byte by byte, alpha too; the share is clamped.
Colour mix(const Colour& a, const Colour& b, double share);
// The colour with its alpha scaled by `share`, 0 to 1.
Colour faded(const Colour& a, double share);

// WCAG 2.1's relative luminance, 0 to 1 (alpha is not looked at), and contrast ratio, 1 to 21.
double relativeLuminance(const Colour& a);
double contrastRatio(const Colour& a, const Colour& b);

}  // namespace vides
