// SPDX-License-Identifier: MIT
// The cube, and the imported scene inside it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "flight/flight.hpp"
#include "math/view_projection.hpp"
#include "scene/draw_list.hpp"
#include "scene/geometry_slot.hpp"
#include "scene/scene_geometry.hpp"
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

// The scene in cube coordinates: made anew where the scene or the space is another. In chunks that
// every OpenGL 3.3 can hold in one buffer texture; those that cannot be seen are left out.
class ScenePart {
 public:
  void add(DrawList& list, const SharedScene& scene, const Space& space, bool asPoints,
           const Theme& theme, float lineWidth);

 private:
  struct Chunk {
    SharedGeometry geometry;
    Vec3 low{0.0}, high{0.0};
  };
  template <class Elements, class Place>
  static std::vector<Chunk> divide(Primitive primitive, const Elements& elements, Place place);

  SharedScene scene_;
  Space space_;
  std::vector<Chunk> edges_, points_;
  bool asPoints_ = false;
};

}  // namespace vides
