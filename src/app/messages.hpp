// SPDX-License-Identifier: MIT
// What the program says about its work: on standard error, after its name.
#pragma once

#include <string_view>

namespace vides {

// "vides: MESSAGE" and a line end. One line, whatever names it has (flight/printable.hpp).
void tell(std::string_view message);

}  // namespace vides
