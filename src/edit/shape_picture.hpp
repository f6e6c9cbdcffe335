// SPDX-License-Identifier: MIT
// A small picture of what a shape does: the curve through three points, the middle one with it.
#pragma once

#include <vector>

#include "math/kochanek_bartels.hpp"
#include "math/vector.hpp"

namespace vides {

struct ShapePicture {
  Vec2 key{0.0};           // the point that has the shape
  std::vector<Vec2> line;  // from the point before to the one after; the middle one is the key
};

// In a square from 0 to 1, y down. `chords` (at least 1) of each of the two pieces. The three
// points lie askew, so that bias and continuity show; strong shapes may reach beyond the square.
ShapePicture shapePicture(const Shape& shape, int chords = 12);

}  // namespace vides
