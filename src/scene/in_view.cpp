// SPDX-License-Identifier: MIT
// Lines clipped by the picture's edges in clip coordinates.
#include "scene/in_view.hpp"

#include <algorithm>
#include <array>

namespace vides {
namespace {

using Clip = glm::dvec4;

constexpr double kNear = 1e-9;

// Distances from the sides, from the inside above 0: left, right, below, above, in front.
std::array<double, 5> insides(const Clip& p) {
  return {p.w + p.x, p.w - p.x, p.w + p.y, p.w - p.y, p.w - kNear};
}

bool seesLine(const Clip& a, const Clip& b) {
  const auto from = insides(a), to = insides(b);
  double enter = 0.0, leave = 1.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i] < 0.0 && to[i] < 0.0) return false;
    const double at = from[i] / (from[i] - to[i]);
    if (from[i] < 0.0) enter = std::max(enter, at);
    if (to[i] < 0.0) leave = std::min(leave, at);
  }
  return enter <= leave;
}

bool sees(const DrawList& list, const DrawItem& item) {
  const Geometry& geometry = *item.geometry;
  const glm::dmat4& matrix = list.view.matrix();
  const auto clip = [&](std::size_t i) {
    const GeometryPoint& p = geometry.points[i];
    return matrix * Clip(item.place.at(Vec3(p.x, p.y, p.z)), 1.0);
  };
  const std::size_t first = std::min(item.first, geometry.elements());
  const std::size_t past = first + std::min(item.count, geometry.elements() - first);
  for (std::size_t e = first; e < past; ++e) {
    switch (geometry.primitive) {
      case Primitive::kMarkers: {
        const Clip p = clip(e);
        if (seesLine(p, p)) return true;
        break;
      }
      case Primitive::kSegments:
        if (seesLine(clip(2 * e), clip(2 * e + 1))) return true;
        break;
      case Primitive::kPolylines:
        if (geometry.points[e + 1].along >= 0.0f && seesLine(clip(e + 1), clip(e + 2))) return true;
        break;
      case Primitive::kTriangles:
        for (std::size_t i = 0; i < 3; ++i) {
          if (seesLine(clip(3 * e + i), clip(3 * e + (i + 1) % 3))) return true;
        }
        break;
    }
  }
  return false;
}

}  // namespace

bool anythingInView(const DrawList& list) {
  return std::any_of(list.items.begin(), list.items.end(), [&](const DrawItem& item) {
    return item.space == DrawSpace::kCube && sees(list, item);
  });
}

}  // namespace vides
