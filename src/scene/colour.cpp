// SPDX-License-Identifier: MIT
// Mixes colours and measures how well two can be told apart.
#include "scene/colour.hpp"

#include <algorithm>
#include <cmath>

#include "math/whole.hpp"

namespace vides {
namespace {

std::uint8_t mixed(std::uint8_t a, std::uint8_t b, double share) {
  return static_cast<std::uint8_t>(wholeWithin(std::round(a + (b - a) * share), 0, 255));
}

// WCAG 2.1, "relative luminance", with the threshold of sRGB's own standard.
double linear(std::uint8_t byte) {
  const double value = byte / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

Colour mix(const Colour& a, const Colour& b, double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return {mixed(a.red, b.red, s), mixed(a.green, b.green, s), mixed(a.blue, b.blue, s),
          mixed(a.alpha, b.alpha, s)};
}

Colour faded(const Colour& a, double share) {
  return {a.red, a.green, a.blue, mixed(0, a.alpha, std::clamp(share, 0.0, 1.0))};
}

double relativeLuminance(const Colour& a) {
  return 0.2126 * linear(a.red) + 0.7152 * linear(a.green) + 0.0722 * linear(a.blue);
}

double contrastRatio(const Colour& a, const Colour& b) {
  const double la = relativeLuminance(a), lb = relativeLuminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace vides
