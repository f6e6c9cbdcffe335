// SPDX-License-Identifier: MIT
// Numbers as they are typed: sums, and what starts from the number that is there.
//
// `0.1+0.2`, `2*(3-1)`, `-0.1` and `+0.1` are values. `*2`, `/2`, `+=0.1`, `-=0.1` (and `*=`, `/=`)
// start from the number that is there, its own: `*2+1` is twice that and one more, `+=1*2` two more
// than that. * and / go before + and -, from left to right; brackets may be nested. Each number has
// a decimal point or a decimal comma, in every locale; the typographic signs − × ÷ are signs, too.
#pragma once

#include <string_view>
#include <tl/expected.hpp>

#include "edit/text.hpp"

namespace vides {

// Whether its value depends on the number that is there.
bool startsFromOwn(std::string_view text);

// A finite number, never -0; else what is wrong, and at which character, counted from 1.
tl::expected<double, Text> evaluateSum(std::string_view text, double own = 0.0);

}  // namespace vides
