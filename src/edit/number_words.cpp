// SPDX-License-Identifier: MIT
// How many decimals a number in a sentence has.
#include "edit/number_words.hpp"

#include <algorithm>
#include <cmath>

namespace vides {

Text numberWords(double value, int digits) {
  constexpr int kMost = 9;
  const double size = std::abs(value);
  if (!(size > 0.0) || !std::isfinite(size)) return Text("number.0", {value});
  const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
  int decimals = std::clamp(digits - before, 0, kMost);
  const auto rounded = [&](int places) {
    const double unit = std::pow(10.0, places);
    return std::round(value * unit) / unit;
  };
  while (decimals > 0 && rounded(decimals - 1) == rounded(decimals)) --decimals;
  return Text("number." + std::to_string(decimals), {value});
}

}  // namespace vides
