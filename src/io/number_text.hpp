// SPDX-License-Identifier: MIT
// Numbers as text, fast and without a locale: what frames are written with, a million a second.
#pragma once

#include <cstddef>
#include <cstdint>

namespace vides {

// Room that each of the writers may need: a sign, 309 digits, the point, six decimals.
inline constexpr std::size_t kMostNumberBytes = 320;

// All write from `out` on, end without a NUL, and return where the text ends.

// The digits of C's "%.4f" and "%.6f": the exact value rounded, ties to even. Never -0.0000.
// Finite.
char* writeFixed4(char* out, double value);
char* writeFixed6(char* out, double value);
// The shortest text that reads back to the same double, as fmt's "{}" has it; -0 as 0. Finite.
char* writeShortest(char* out, double value);
char* writeInteger(char* out, std::int64_t value);

}  // namespace vides
