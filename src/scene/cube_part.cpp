// SPDX-License-Identifier: MIT
// Decides which of the cube's edges lie behind.
#include "scene/cube_part.hpp"

#include <algorithm>
#include <glm/common.hpp>

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

void CubePart::add(DrawList& list, const Theme& theme, double contentScale, float lineWidth) {
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
  item.style = LineStyle{dim, lineWidth, 4.5f * scale, 4.5f * scale};
  item.lift = -2;
  list.items.push_back(item);
  item.geometry = front_.keep(Primitive::kSegments, std::move(front));
  item.style = LineStyle{colour, lineWidth};
  item.lift = -1;
  list.items.push_back(item);
}

}  // namespace vides
