// SPDX-License-Identifier: MIT
// Puts a scene's edges in order, leaves out what isn't drawn, and measures the rest.
#include "scene/scene_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include <glm/common.hpp>

namespace vides {
namespace {

bool isFinite(const Vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// Leaves out the positions that aren't kept; the others get new numbers in the old order.
void keepOnly(SceneGeometry& scene, const std::vector<std::uint8_t>& kept) {
  if (std::ranges::find(kept, 0) == kept.end()) return;
  std::vector<std::uint32_t> number(scene.positions.size());
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    number[i] = next;
    if (kept[i] != 0) scene.positions[next++] = scene.positions[i];
  }
  scene.positions.resize(next);
  scene.positions.shrink_to_fit();
  for (auto& edge : scene.edges) edge = {number[edge[0]], number[edge[1]]};
  for (auto& corners : scene.triangles) {
    corners = {number[corners[0]], number[corners[1]], number[corners[2]]};
  }
  for (auto& point : scene.points) point = number[point];
}

void keepDrawn(SceneGeometry& scene) {
  std::vector<std::uint8_t> kept(scene.positions.size(), 0);
  for (const auto& edge : scene.edges) kept[edge[0]] = kept[edge[1]] = 1;
  for (const auto point : scene.points) kept[point] = 1;
  keepOnly(scene, kept);
}

void makePoints(SceneGeometry& scene) {
  std::vector<std::uint8_t> kept(scene.positions.size(), 0);
  std::ranges::transform(scene.positions, kept.begin(),
                         [](const Vec3& p) { return isFinite(p) ? 1 : 0; });
  keepOnly(scene, kept);
  if (scene.positions.empty()) return;
  scene.points.resize(scene.positions.size());
  std::iota(scene.points.begin(), scene.points.end(), 0u);
  const auto count = static_cast<std::int64_t>(scene.points.size());
  scene.report.points = count;
  scene.report.notes.push_back({SceneRemark::kVerticesOnly, count, 0, {}});
}

}  // namespace

void finishScene(SceneGeometry& scene) {
  for (auto& edge : scene.edges) {
    if (edge[0] > edge[1]) std::swap(edge[0], edge[1]);
  }
  std::erase_if(scene.edges, [](const auto& edge) { return edge[0] == edge[1]; });
  std::sort(scene.edges.begin(), scene.edges.end());
  // std::ranges::unique gives a subrange, which clang 14 (fuzzing, tidy) cannot compile.
  scene.edges.erase(std::unique(scene.edges.begin(), scene.edges.end()), scene.edges.end());
  std::erase_if(scene.triangles, [](const auto& corners) {
    return corners[0] == corners[1] && corners[1] == corners[2];
  });

  if (scene.edges.empty() && scene.points.empty()) {
    scene.triangles.clear();
    makePoints(scene);
  } else {
    keepDrawn(scene);
  }
  scene.report.vertices = static_cast<std::int64_t>(scene.positions.size());
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
