// SPDX-License-Identifier: MIT
// Decides which of the cube's edges lie behind, and brings a scene into the cube.
#include "scene/cube_part.hpp"

#include <vector>

namespace vides {
namespace {

constexpr double kFacing = 1e-9;

// Whether the face where coordinate `axis` is `sign` is turned to the viewer.
bool facesViewer(const ViewProjection& view, int axis, double sign) {
  if (!view.perspective()) return -sign * view.viewingDirection()[axis] > kFacing;
  return sign * view.referencePoint()[axis] - 1.0 > kFacing;
}

// Whether edge i is seen exactly behind an edge in front, or as a point: in the named views. Its
// dashes would show through the edges of the line before it.
bool isCovered(const ViewProjection& view, std::size_t i, std::uint32_t behind) {
  constexpr double kSamePixel = 0.25;
  const auto a = view.project(cubeCorner(kCubeEdges[i][0]));
  const auto b = view.project(cubeCorner(kCubeEdges[i][1]));
  if (!a || !b) return false;
  if (glm::distance(*a, *b) < kSamePixel) return true;
  for (std::size_t k = 0; k < kCubeEdges.size(); ++k) {
    if ((behind >> k & 1) != 0) continue;
    const auto c = view.project(cubeCorner(kCubeEdges[k][0]));
    const auto d = view.project(cubeCorner(kCubeEdges[k][1]));
    if (c && d && glm::distance(*a, *c) < kSamePixel && glm::distance(*b, *d) < kSamePixel) {
      return true;
    }
  }
  return false;
}

}  // namespace

Vec3 cubeCorner(int number) {
  return {(number & 1) != 0 ? 1.0 : -1.0, (number & 2) != 0 ? 1.0 : -1.0,
          (number & 4) != 0 ? 1.0 : -1.0};
}

std::uint32_t cubeEdgesBehind(const ViewProjection& view) {
  std::uint32_t behind = 0;
  for (std::size_t i = 0; i < kCubeEdges.size(); ++i) {
    const Vec3 a = cubeCorner(kCubeEdges[i][0]), b = cubeCorner(kCubeEdges[i][1]);
    bool faces = false;
    for (int axis = 0; axis < 3; ++axis) {
      if (a[axis] == b[axis]) faces = faces || facesViewer(view, axis, a[axis]);
    }
    if (!faces) behind |= 1u << i;
  }
  return behind;
}

void CubePart::add(DrawList& list, const Theme& theme, double contentScale) {
  std::vector<GeometryPoint> front, back;
  const std::uint32_t behind = cubeEdgesBehind(list.view);
  for (std::size_t i = 0; i < kCubeEdges.size(); ++i) {
    const bool isBehind = (behind >> i & 1) != 0;
    if (isBehind && isCovered(list.view, i, behind)) continue;
    auto& points = isBehind ? back : front;
    for (const int corner : kCubeEdges[i]) points.push_back(geometryPoint(cubeCorner(corner)));
  }
  const auto scale = static_cast<float>(contentScale);
  const Colour colour = theme[ColourRole::kCube];
  const Colour dim = mix(colour, mix(list.groundTop, list.groundBottom, 0.5), 0.4);

  DrawItem item;
  item.geometry = back_.keep(Primitive::kSegments, std::move(back));
  item.style = LineStyle{dim, 1.2f * scale, 4.5f * scale, 4.5f * scale};
  item.lift = -2;
  list.items.push_back(item);
  item.geometry = front_.keep(Primitive::kSegments, std::move(front));
  item.style = LineStyle{colour, 1.2f * scale};
  item.lift = -1;
  list.items.push_back(item);
}

void ScenePart::add(DrawList& list, const SharedScene& scene, const Space& space, bool asPoints,
                    const Theme& theme, double contentScale) {
  if (!scene || scene->empty()) return;
  if (scene != scene_ || !(space == space_)) {
    scene_ = scene;
    space_ = space;
    edges_ = points_ = positions_ = nullptr;
  }
  const auto place = [&](std::uint32_t index) {
    return geometryPoint(space.toCube(scene->positions[index]));
  };
  const auto scale = static_cast<float>(contentScale);
  const Colour colour = theme[ColourRole::kScene];
  DrawItem item;
  item.fade = 0.45f;

  const auto addMarkers = [&](const SharedGeometry& geometry) {
    item.geometry = geometry;
    item.style = MarkerStyle{MarkerShape::kDisc, colour, kNoColour, 1.3f * scale};
    list.items.push_back(item);
  };
  if (asPoints) {
    if (!positions_) {
      auto made = std::make_shared<Geometry>(Geometry{Primitive::kMarkers, {}});
      for (std::uint32_t i = 0; i < scene->positions.size(); ++i) made->points.push_back(place(i));
      positions_ = std::move(made);
    }
    return addMarkers(positions_);
  }
  if (!edges_) {
    auto made = std::make_shared<Geometry>(Geometry{Primitive::kSegments, {}});
    made->points.reserve(2 * scene->edges.size());
    for (const auto& edge : scene->edges) {
      made->points.push_back(place(edge[0]));
      made->points.push_back(place(edge[1]));
    }
    edges_ = std::move(made);
    made = std::make_shared<Geometry>(Geometry{Primitive::kMarkers, {}});
    for (const std::uint32_t point : scene->points) made->points.push_back(place(point));
    points_ = std::move(made);
  }
  if (!points_->points.empty()) addMarkers(points_);
  item.geometry = edges_;
  item.style = LineStyle{colour, 1.2f * scale};
  list.items.push_back(item);
}

}  // namespace vides
