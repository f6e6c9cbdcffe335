// SPDX-License-Identifier: MIT
// The geometry of an imported scene, in scene units (Flight::space maps them to the cube).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "math/vector.hpp"
#include "scene/scene_report.hpp"

namespace vides {

struct BoundingBox {
  Vec3 low{0.0}, high{0.0};
  Vec3 center() const { return 0.5 * (low + high); }
  bool operator==(const BoundingBox&) const = default;
};

// Every index is below positions.size(); every position is finite, and drawn by an edge or a point.
struct SceneGeometry {
  std::vector<Vec3> positions;
  std::vector<std::array<std::uint32_t, 2>> edges;      // each once, first < second, sorted
  std::vector<std::array<std::uint32_t, 3>> triangles;  // faces cut into fans
  // Single points that the file names; all positions where it has nothing else to draw.
  std::vector<std::uint32_t> points;
  // Of all positions; nothing where there are none.
  std::optional<BoundingBox> box;
  SceneReport report;

  bool empty() const { return positions.empty(); }
};

// Brings what a reader has collected into that form: edges in order, those from a point to itself
// and triangles with one corner left out; positions that nothing draws (only they may be not
// finite) left out, or, where nothing else is drawn, those that are finite made points. Counts
// vertices, and such points, in the report.
void finishScene(SceneGeometry& scene);

std::optional<BoundingBox> boundsOf(const std::vector<Vec3>& positions);

}  // namespace vides
