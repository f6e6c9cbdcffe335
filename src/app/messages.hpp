// SPDX-License-Identifier: MIT
// What the program says about its work: on standard error.
#pragma once

#include <string_view>

namespace vides {

// "vides: MESSAGE" and a line end. One line, whatever names it has (flight/printable.hpp).
void tell(std::string_view message);
// A line that begins with the file and the place that it is about.
void tellLine(std::string_view line);

}  // namespace vides
