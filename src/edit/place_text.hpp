// SPDX-License-Identifier: MIT
// Where in a flight something is wrong, in the words of the window instead of a JSON pointer.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "edit/text.hpp"
#include "flight/problem.hpp"

namespace vides {

// "Key 3, orientation 1, zoom: expected …": keys and orientations counted from 1 as everywhere on
// screen. Other places than those of keys keep the pointer.
Text refusalOf(const Problem& problem);

// The reference tokens of a JSON pointer as they stand there, and the number that one of them is.
std::vector<std::string_view> tokensOf(std::string_view pointer);
std::optional<std::size_t> indexIn(std::string_view token);

}  // namespace vides
