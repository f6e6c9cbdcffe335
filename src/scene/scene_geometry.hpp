// SPDX-License-Identifier: MIT
// The geometry of an imported scene, in scene units (Flight::space maps them to the cube).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "math/vector.hpp"

namespace vides {

struct BoundingBox {
  Vec3 low{0.0}, high{0.0};
  Vec3 center() const { return 0.5 * (low + high); }
  bool operator==(const BoundingBox&) const = default;
};

// Every index is below positions.size(); every position is finite.
struct SceneGeometry {
  std::vector<Vec3> positions;
  std::vector<std::array<std::uint32_t, 2>> edges;      // each once, first < second, sorted
  std::vector<std::array<std::uint32_t, 3>> triangles;  // faces cut into fans
  std::vector<std::uint32_t> points;                    // single points that the file names
  // Of all positions; nothing where there are none.
  std::optional<BoundingBox> box;

  bool empty() const { return positions.empty(); }
};

// Sorts the edges, takes each once, drops those from a point to itself, and measures the box.
void finishScene(SceneGeometry& scene);

std::optional<BoundingBox> boundsOf(const std::vector<Vec3>& positions);

}  // namespace vides
