// SPDX-License-Identifier: MIT
// Finds places for labels where they cover neither marks nor lines nor each other.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "math/vector.hpp"
#include "math/view_projection.hpp"

namespace vides {

// Keeps a coarse map of what is covered.
class LabelPlacer {
 public:
  // `cell`: pixels along the side of a cell of the map.
  LabelPlacer(const PixelRectangle& area, double cell);

  // `weight`: how bad it is to cover this.
  void blockBox(const Vec2& low, const Vec2& high, std::uint8_t weight);
  void blockLine(const Vec2& from, const Vec2& to, std::uint8_t weight);

  struct Place {
    Vec2 corner{0.0};     // the box's upper left one
    bool away = false;    // farther than usual
    bool covers = false;  // something lies under it
  };
  // Of a box of `size` beside `anchor`, `gap` pixels away or some more; blocks it. Nothing where
  // every place is too bad and the label is not `needed`.
  std::optional<Place> place(const Vec2& anchor, double gap, const Vec2& size, bool needed);

 private:
  struct Cells {
    int left, top, right, bottom;
  };
  // The column or row of a place, -1 before the first one, `count` behind the last.
  int cellOf(double value, double origin, int count) const;
  Cells cellsOf(const Vec2& low, const Vec2& high) const;
  int cost(const Vec2& low, const Vec2& high) const;

  PixelRectangle area_;
  double cell_;
  int columns_, rows_;
  std::vector<std::uint8_t> covered_;
};

inline constexpr std::uint8_t kBlockedByLine = 2;
inline constexpr std::uint8_t kBlockedByMark = 12;
inline constexpr std::uint8_t kBlockedByLabel = 40;

}  // namespace vides
