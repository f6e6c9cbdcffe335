// SPDX-License-Identifier: MIT
// Draws one smooth triangle, the same on every host.
#pragma once

#include "host/host.hpp"

namespace vides::test {

// Fills the host's picture with a dark ground and a triangle whose corners are red (left bottom),
// green (right bottom) and blue (top). Aborts where OpenGL complains. False where
// the host has nothing to draw into.
bool drawTriangle(Host& host);

}  // namespace vides::test
