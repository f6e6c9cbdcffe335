// SPDX-License-Identifier: MIT
// The arc length of a cubic piece and its inverse (paper 5.1).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "math/cubic_segment.hpp"

namespace vides {

// A table over one CubicSegment. Lengths are in the segment's units.
//
// length() and lengthAt() are exact to 1e-12 relative; parameterAt() satisfies
// |lengthAt(parameterAt(s)) - s| <= 1e-12 length(), also on cusps and zero tangents. The integral
// is split at the real roots of d|Q'|^2/du (where |Q'| may turn sharply) and then adaptively,
// Gauss- Legendre 8 against 2 x 8 points. Asks for the same segment that it was built from, so that
// the table itself stays small. Every result is a pure function of the segment and the argument. A
// segment of length 0 has one panel; its parameterAt() is 0 for s <= 0 and 1 beyond.
class ArcLength {
 public:
  ArcLength() = default;
  explicit ArcLength(const CubicSegment& segment);

  double length() const { return length_; }
  // Length from u = 0 to u; u is clamped into [0, 1].
  double lengthAt(const CubicSegment& segment, double u) const;
  // The u at which the arc length from the start is s; s is clamped into [0, length()]. Returns
  // exactly 0 for s <= 0 and exactly 1 for s >= length().
  double parameterAt(const CubicSegment& segment, double s) const;

 private:
  struct Panel {
    double u = 0.0;      // where the panel starts
    double s = 0.0;      // length up to there
    double speed = 0.0;  // |Q'(u)| there
  };
  class Builder;

  // Most tables fit into the object: looking into one in a long flight is waiting for memory.
  class PanelList {
   public:
    void assign(const std::vector<Panel>& panels);
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    const Panel* begin() const { return size_ <= kInPlace ? near_.data() : far_.data(); }
    const Panel* end() const { return begin() + size_; }

   private:
    static constexpr std::size_t kInPlace = 16;
    std::size_t size_ = 0;
    std::array<Panel, kInPlace> near_{};
    std::vector<Panel> far_;
  };

  double length_ = 0.0;
  PanelList panels_;  // with one closing entry at u = 1
};

}  // namespace vides
