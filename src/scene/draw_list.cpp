// SPDX-License-Identifier: MIT
// Makes geometry and counts its elements.
#include "scene/draw_list.hpp"

#include <algorithm>

namespace vides {

GeometryPoint geometryPoint(const Vec3& point, float along) {
  return {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z),
          along};
}

GeometryPoint geometryPoint(const Vec2& pixel, float along) {
  return geometryPoint(Vec3(pixel, 0.0), along);
}

std::size_t Geometry::elements() const {
  switch (primitive) {
    case Primitive::kPolylines:
      return points.size() < 4 ? 0 : points.size() - 3;
    case Primitive::kSegments:
      return points.size() / 2;
    case Primitive::kMarkers:
      return points.size();
    case Primitive::kTriangles:
      return points.size() / 3;
  }
  return 0;
}

SharedGeometry PolylineBuilder::finish() {
  points_.push_back({0, 0, 0, kLineEnds});
  auto geometry = std::make_shared<Geometry>();
  geometry->primitive = Primitive::kPolylines;
  geometry->points = std::move(points_);
  points_.assign(1, {0, 0, 0, kLineEnds});
  return geometry;
}

}  // namespace vides
