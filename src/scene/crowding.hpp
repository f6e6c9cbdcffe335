// SPDX-License-Identifier: MIT
// How crowded signs stand in a picture, and how large each is drawn for it: signs that would bury
// what they stand on become smaller, and of very many only some are drawn.
//
// Everything here is continuous in the signs' places: when the view turns a little no sign jumps,
// and which ones stay depends on their numbers alone, not on where they fall in the picture.
#pragma once

#include <cstddef>
#include <vector>

#include "math/vector.hpp"
#include "math/view_projection.hpp"

namespace vides {

// A coarse map of how many signs stand where, each spread over some cells by a smooth weight.
class Crowding {
 public:
  // `cell`: pixels along the side of a cell; signs farther apart than four cells never count.
  // What was added before is forgotten.
  void begin(const PixelRectangle& area, double cell);
  // Signs outside the area count as far as they reach into it.
  void add(const Vec2& pixel);
  // How many others stand at a sign that was added: 0 where it stands alone, about 0.23 for each
  // at the very same place; in an even row about 0.48 of a cell by the distance, and on an even
  // surface a cell's area by that of each, less 0.23.
  double around(const Vec2& pixel) const;

 private:
  struct Spread {
    std::size_t first;  // of four rows of four cells
    float x[4], y[4];
  };
  bool spread(const Vec2& pixel, Spread& result) const;

  PixelRectangle area_;
  double perCell_ = 1.0;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<float> cells_;
};

// The side of a cell, in radii of a cross, for which crossShare() holds.
inline constexpr double kCrowdingRadii = 2.5;

// How large the sign with this number is drawn, 0 (not at all) to 1: whole where it has room,
// smaller where the signs would touch each other. Of many at a place every second, fourth, … number
// goes, the lower powers of two first.
double crossShare(double crowding, std::size_t number);

}  // namespace vides
