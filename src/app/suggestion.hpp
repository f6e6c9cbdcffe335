// SPDX-License-Identifier: MIT
// "Did you mean": the known word that a mistyped one is most likely meant to be.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace vides {

// How many letters must be put in, left out, replaced or swapped with a neighbour.
std::size_t editDistance(std::string_view a, std::string_view b);
// The nearest of the words, the first of several; empty if none is within a third of its letters.
std::string nearestWord(std::string_view mistyped, std::span<const std::string> words);

}  // namespace vides
