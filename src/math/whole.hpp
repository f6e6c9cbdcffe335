// SPDX-License-Identifier: MIT
// From numbers to whole ones: what lies beyond the integers, and NaN, has no whole part that C++
// would promise anything of.
#pragma once

#include <cstdint>

namespace vides {

// The whole part of a number, within bounds (below 2^53 in size); NaN gives `low`.
constexpr std::int64_t wholeWithin(double value, std::int64_t low, std::int64_t high) {
  if (!(value > static_cast<double>(low))) return low;
  return value < static_cast<double>(high) ? static_cast<std::int64_t>(value) : high;
}

}  // namespace vides
