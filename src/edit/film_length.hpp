// SPDX-License-Identifier: MIT
// How long a film, a section or a hold is, as all who tell it have it: rounded in one place.
#pragma once

#include <cstdint>

namespace vides {

// Times are told in hundredths of a second, halves up.
inline constexpr int kTimeDecimals = 2;

// In units of 10^-decimals seconds.
std::int64_t timeTicks(double seconds, int decimals = kTimeDecimals);
// frames / frameRate, rounded so: what any number format with two decimals shows unchanged.
double toldSeconds(std::int64_t frames, double frameRate);

}  // namespace vides
