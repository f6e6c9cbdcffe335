// SPDX-License-Identifier: MIT
// Where in a flight something is wrong, in the words of the window instead of a JSON pointer.
#pragma once

#include "edit/text.hpp"
#include "flight/problem.hpp"

namespace vides {

// "Key 3, orientation 1, zoom: expected …": keys and orientations counted from 1 as everywhere on
// screen. Other places than those of keys keep the pointer.
Text refusalOf(const Problem& problem);

}  // namespace vides
