// SPDX-License-Identifier: MIT
// The plane drag: from a pointer's way in pixels to a point's way in the cube.
#include "math/plane_drag.hpp"

#include <cmath>

namespace vides {
namespace {

DragRefusal edgeOn(Axis constant) {
  switch (constant) {
    case Axis::X:
      return DragRefusal::PlaneXEdgeOn;
    case Axis::Y:
      return DragRefusal::PlaneYEdgeOn;
    case Axis::Z:
      break;
  }
  return DragRefusal::PlaneZEdgeOn;
}

DragRefusal endOn(Axis free) {
  switch (free) {
    case Axis::X:
      return DragRefusal::AxisXEndOn;
    case Axis::Y:
      return DragRefusal::AxisYEndOn;
    case Axis::Z:
      break;
  }
  return DragRefusal::AxisZEndOn;
}

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

double smallestSingularValue(const Vec2& a, const Vec2& b) {
  const double aa = glm::dot(a, a), bb = glm::dot(b, b), ab = glm::dot(a, b);
  const double largest = std::sqrt(0.5 * (aa + bb + std::hypot(aa - bb, 2.0 * ab)));
  return largest > 0.0 ? std::abs(cross(a, b)) / largest : 0.0;
}

tl::expected<Vec3, DragRefusal> dragInPlane(const Grab& grab, Axis constant, const Vec2& pointer) {
  const auto start = grab.view.project(grab.point);
  if (!start) return tl::unexpected(DragRefusal::NotInFront);
  const int k = static_cast<int>(constant), i = (k + 1) % 3, j = (k + 2) % 3;
  const glm::dmat3x2 jacobian = grab.view.jacobian(grab.point);
  const Vec2 a = jacobian[i], b = jacobian[j];
  if (smallestSingularValue(a, b) < kEdgeOnPixelsPerUnit) return tl::unexpected(edgeOn(constant));

  const Vec2 way = pointer - grab.pointer;
  Vec3 point = grab.point;
  if (!grab.view.perspective()) {
    const double d = cross(a, b);
    point[i] += cross(way, b) / d;
    point[j] += cross(a, way) / d;
    return point;
  }
  const Ray ray = grab.view.ray(*start + way);
  const double distance = (point[k] - ray.origin[k]) / ray.direction[k];
  if (!(distance > 0.0 && std::isfinite(distance))) {
    return tl::unexpected(DragRefusal::BeyondHorizon);
  }
  point[i] = ray.origin[i] + distance * ray.direction[i];
  point[j] = ray.origin[j] + distance * ray.direction[j];
  return point;
}

tl::expected<Vec3, DragRefusal> dragAlongAxis(const Grab& grab, Axis free, const Vec2& pointer) {
  const double weight = grab.view.weight(grab.point);
  if (!(weight > 0.0)) return tl::unexpected(DragRefusal::NotInFront);
  const int k = static_cast<int>(free);
  const Vec2 a = grab.view.jacobian(grab.point)[k];
  if (glm::length(a) < kEdgeOnPixelsPerUnit) return tl::unexpected(endOn(free));

  // The axis projects to a line; the foot of the pointer's perpendicular on it lies `foot` times a
  // from the start. A way s along the axis reaches s w / (w + s w') times a, where w' is the change
  // of the weight w along the axis.
  const double foot = glm::dot(pointer - grab.pointer, a) / glm::dot(a, a);
  const double rest = weight - foot * grab.view.weightGradient()[k];
  if (!(rest > 0.0)) return tl::unexpected(DragRefusal::BeyondHorizon);
  Vec3 point = grab.point;
  point[k] += foot * weight / rest;
  return point;
}

}  // namespace vides
