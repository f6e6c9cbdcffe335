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
  void add(const Vec2& pixel) { change(pixel, 1.0); }
  // Exactly as if this one, which was added, never had been: in any order.
  void remove(const Vec2& pixel) { change(pixel, -1.0); }
  // Whether what around() says here may have changed since the last settle(); before the first
  // one after begin() it always may have.
  bool changed(const Vec2& pixel) const;
  void settle();
  // How many others stand at a sign that was added: 0 where it stands alone, about 0.23 for each
  // at the very same place; in an even row about 0.48 of a cell by the distance, and on an even
  // surface a cell's area by that of each, less 0.23.
  double around(const Vec2& pixel) const;

 private:
  struct Spread {
    std::size_t column, row;  // of the first of four rows of four cells
    double x[4], y[4];
  };
  // In cells from the map's corner.
  Vec2 inCells(const Vec2& pixel) const;
  bool spread(const Vec2& pixel, Spread& result) const;
  void change(const Vec2& pixel, double sign);
  void mark(std::size_t column, std::size_t row);

  PixelRectangle area_;
  double perCell_ = 1.0;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<double> cells_;
  std::vector<char> changed_;  // for each cell: signs in it read some cell that changed
  bool allChanged_ = true, anyChanged_ = false;
};

// The side of a cell, in radii of a cross, for which crossShare() holds.
inline constexpr double kCrowdingRadii = 2.5;

// How large the sign with this number is drawn, 0 (not at all) to 1: whole where it has room,
// smaller where the signs would touch each other. Of many at a place every second, fourth, … number
// goes, the lower powers of two first.
double crossShare(double crowding, std::size_t number);

}  // namespace vides
