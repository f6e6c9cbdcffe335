// SPDX-License-Identifier: MIT
// Frames to seconds.
#include "edit/film_length.hpp"

#include <cmath>

#include "math/whole.hpp"

namespace vides {

std::int64_t timeTicks(double seconds, int decimals) {
  // 29 frames of 100 a second are 0.29 s, however it is represented.
  constexpr std::int64_t kMost = std::int64_t{1} << 52;  // nobody reads longer times
  return wholeWithin(std::floor(seconds * std::pow(10.0, decimals) + 0.5 + 1e-6), 0, kMost);
}

double toldSeconds(std::int64_t frames, double frameRate) {
  return static_cast<double>(timeTicks(static_cast<double>(frames) / frameRate)) / 100.0;
}

}  // namespace vides
