// SPDX-License-Identifier: MIT
// Whether anything of what is drawn falls into the picture.
#pragma once

#include "scene/draw_list.hpp"

namespace vides {

// Of the list's items in the cube. Looks no further than the first line, point or triangle that is
// seen.
bool anythingInView(const DrawList& list);

}  // namespace vides
