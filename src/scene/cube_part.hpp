// SPDX-License-Identifier: MIT
// The cube: its edges in front solid, those behind dashed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/view_projection.hpp"
#include "scene/draw_list.hpp"
#include "scene/geometry_slot.hpp"
#include "scene/theme.hpp"

namespace vides {

// The corners are numbered by their signs: bit 0 is x > 0, bit 1 y > 0, bit 2 z > 0.
inline constexpr std::array<std::array<int, 2>, 12> kCubeEdges{{{0, 1},
                                                                {2, 3},
                                                                {4, 5},
                                                                {6, 7},
                                                                {0, 2},
                                                                {1, 3},
                                                                {4, 6},
                                                                {5, 7},
                                                                {0, 4},
                                                                {1, 5},
                                                                {2, 6},
                                                                {3, 7}}};
Vec3 cubeCorner(int number);

// Bit i is set if edge i lies behind: both faces that meet in it are turned away from the viewer,
// or seen edge-on. From inside the cube all edges lie behind.
std::uint32_t cubeEdgesBehind(const ViewProjection& view);

class CubePart {
 public:
  // `lineWidth` is in pixels.
  void add(DrawList& list, const Theme& theme, double contentScale, float lineWidth);

 private:
  GeometrySlot front_, back_;
};

}  // namespace vides
