// SPDX-License-Identifier: MIT
// Where a note beside the pointer stands without covering what it is about.
#pragma once

#include <span>

#include "panels/ui.hpp"
#include "scene/draw_list.hpp"

namespace vides {

// A box of `size` near the pointer, inside `room` if it fits there: below it and at its right,
// unless it would lie over handles; then on another side or farther away, where it covers fewest.
Rect notePlace(const Rect& room, const ImVec2& size, const ImVec2& pointer,
               std::span<const Handle> handles, float scale);

}  // namespace vides
