// SPDX-License-Identifier: MIT
// Names of files on the screen.
#pragma once

#include <string>
#include <string_view>

#include "panels/ui.hpp"

namespace vides {

// A name (or a path) told from every other: what the fonts have no sign for is written in escapes
// (flight/printable.hpp), and noted, so that another font may have it from the next display frame
// on.
std::string shownName(Ui& ui, std::string_view name);

}  // namespace vides
