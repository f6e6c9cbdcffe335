// SPDX-License-Identifier: MIT
// Numbers inside sentences, with as many decimals as they deserve.
#pragma once

#include "edit/text.hpp"

namespace vides {

// A number with `digits` significant ones, without zeros at its end; whole ones as they are.
Text numberWords(double value, int digits = 4);

}  // namespace vides
