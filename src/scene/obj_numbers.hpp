// SPDX-License-Identifier: MIT
// Numbers and indices as OBJ files have them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace vides {

// A number; "nan", "inf" and what C libraries print for them ("-nan(ind)", "1.#QNAN") are numbers,
// too. Beyond what a double holds it is infinite or 0. Nothing: no number.
std::optional<double> objNumber(std::string_view word);

// The vertex's number of an index group: "7", "7/1/3", "-1//2". Nothing: no integer other than 0,
// or what stands behind it is none. What 64 bits don't hold is the largest or smallest that they
// do.
std::optional<std::int64_t> objIndex(std::string_view group);

}  // namespace vides
