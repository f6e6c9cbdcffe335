// SPDX-License-Identifier: MIT
// Positions joined in nested grids: each cell stands for the positions in it, by their mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "math/vector.hpp"

namespace vides {

// The grids are as wide as most of the positions lie apart: a few far away have cells of their own
// and make the others no coarser. A cell lies in one cell of the next coarser grid. Grids that
// would join hardly anything are left out.
class CellTree {
 public:
  struct Level {
    double cell = 0.0;                  // width of the cells
    std::vector<Vec3> means;            // of each cell's positions
    std::vector<std::uint32_t> parent;  // the cell of the next level; empty of the last one
  };

  CellTree() = default;
  // `tell` hears the share that is done, 0 to 1; false stops it.
  CellTree(const std::vector<Vec3>& positions, const std::function<bool(double)>& tell);

  // Finest first; none where nothing could be joined.
  const std::vector<Level>& levels() const { return levels_; }
  // The cell of each position in the finest grid; empty where there is none.
  const std::vector<std::uint32_t>& cells() const { return cells_; }

 private:
  std::vector<Level> levels_;
  std::vector<std::uint32_t> cells_;
};

// About the middle of most positions.
struct Body {
  Vec3 low{0.0}, high{0.0};
  Vec3 center() const { return 0.5 * low + 0.5 * high; }
};
Body bodyOf(const std::vector<Vec3>& positions);

}  // namespace vides
