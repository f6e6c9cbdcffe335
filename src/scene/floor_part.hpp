// SPDX-License-Identifier: MIT
// The ground under the cube and the horizon: what a camera without a scene flies over.
#pragma once

#include <array>
#include <optional>

#include "scene/draw_list.hpp"
#include "scene/geometry_slot.hpp"
#include "scene/theme.hpp"

namespace vides {

// Where the plane y = const at infinity is seen in a perspective view: two points of a line that
// reaches beyond the rectangle on both sides. Nothing where the horizon is far outside.
std::optional<std::array<Vec2, 2>> horizon(const ViewProjection& view);

class FloorPart {
 public:
  // Into a list whose view is a perspective.
  void add(DrawList& list, const Theme& theme, double contentScale);

 private:
  std::array<GeometrySlot, 3> grids_;
  GeometrySlot horizon_;
};

}  // namespace vides
