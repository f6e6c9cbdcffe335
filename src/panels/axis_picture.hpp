// SPDX-License-Identifier: MIT
// Small pictures of how a scene stands: its axes, turned upright.
#pragma once

#include "flight/up_axis.hpp"
#include "panels/ui.hpp"

namespace vides {

// The axis as it is written: "y", "−y".
std::string axisWords(UpAxis axis);

// The file's three axes as they stand when `up` points up, that one marked; in the middle of a box.
void axisPicture(Ui& ui, const Rect& box, UpAxis up);

}  // namespace vides
