// SPDX-License-Identifier: MIT
// Puts a scene's edges in order and joins scenes.
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

  scene.box.reset();
  for (const Vec3& p : scene.positions) {
    if (!scene.box) scene.box = BoundingBox{p, p};
    scene.box->low = glm::min(scene.box->low, p);
    scene.box->high = glm::max(scene.box->high, p);
  }
}

void appendScene(SceneGeometry& scene, const SceneGeometry& other) {
  const auto base = static_cast<std::uint32_t>(scene.positions.size());
  scene.positions.insert(scene.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& edge : other.edges) scene.edges.push_back({edge[0] + base, edge[1] + base});
  for (const auto& t : other.triangles) {
    scene.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  for (const auto point : other.points) scene.points.push_back(point + base);
}

}  // namespace vides
