// SPDX-License-Identifier: MIT
// Puts a scene's edges in order and measures it.
#include "scene/scene_geometry.hpp"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

namespace vides {

void finishScene(SceneGeometry& scene) {
  for (auto& edge : scene.edges) {
    if (edge[0] > edge[1]) std::swap(edge[0], edge[1]);
  }
  std::erase_if(scene.edges, [](const auto& edge) { return edge[0] == edge[1]; });
  std::sort(scene.edges.begin(), scene.edges.end());
  // std::ranges::unique gives a subrange, which clang 14 (fuzzing, tidy) cannot compile.
  scene.edges.erase(std::unique(scene.edges.begin(), scene.edges.end()), scene.edges.end());

  scene.box = boundsOf(scene.positions);
}

std::optional<BoundingBox> boundsOf(const std::vector<Vec3>& positions) {
  if (positions.empty()) return std::nullopt;
  BoundingBox box{positions.front(), positions.front()};
  for (const Vec3& p : positions) {
    box.low = glm::min(box.low, p);
    box.high = glm::max(box.high, p);
  }
  return box;
}

}  // namespace vides
