// SPDX-License-Identifier: MIT
// Builds the matrices of PHIGS' viewing pipeline.
#include "math/projection.hpp"

#include <optional>

#include "math/quaternion.hpp"

namespace vides {
namespace {

// Rows as they stand on paper; glm stores columns.
glm::dmat4 fromRows(const glm::dvec4& x, const glm::dvec4& y, const glm::dvec4& z,
                    const glm::dvec4& w) {
  return glm::transpose(glm::dmat4(x, y, z, w));
}

std::optional<ViewMappingError> errorIn(const ViewMapping& m) {
  if (!(m.window.uMin < m.window.uMax && m.window.vMin < m.window.vMax)) {
    return ViewMappingError::EmptyWindow;
  }
  if (!(m.backPlaneDistance < m.frontPlaneDistance)) {
    return ViewMappingError::BackPlaneNotBehindFrontPlane;
  }
  const double prp = m.projectionReferencePoint.z;
  if (!(prp < m.viewPlaneDistance || prp > m.viewPlaneDistance)) {
    return ViewMappingError::ReferencePointOnViewPlane;
  }
  if (m.type == ProjectionType::Perspective && !(prp > m.frontPlaneDistance)) {
    return ViewMappingError::ReferencePointNotBeforeFrontPlane;
  }
  return std::nullopt;
}

// Shears along the direction of projection onto the view plane (by -x/z and -y/z, see the errata),
// then scales the window and the depth.
glm::dmat4 parallelMapping(const ViewMapping& m) {
  const Vec2 center = m.window.center();
  const Vec3& prp = m.projectionReferencePoint;
  const Vec3 direction{center.x - prp.x, center.y - prp.y, m.viewPlaneDistance - prp.z};
  const double shearU = -direction.x / direction.z, shearV = -direction.y / direction.z;
  const double scaleU = 2.0 / (m.window.uMax - m.window.uMin);
  const double scaleV = 2.0 / (m.window.vMax - m.window.vMin);
  const double depth = m.frontPlaneDistance - m.backPlaneDistance;
  const double vpd = m.viewPlaneDistance;
  return fromRows({scaleU, 0.0, scaleU * shearU, -scaleU * (shearU * vpd + center.x)},
                  {0.0, scaleV, scaleV * shearV, -scaleV * (shearV * vpd + center.y)},
                  {0.0, 0.0, -2.0 / depth, (m.frontPlaneDistance + m.backPlaneDistance) / depth},
                  {0.0, 0.0, 0.0, 1.0});
}

// With w = prp.n - n and the view plane at w = d, a point projects to
// u' = prp.u + (u - prp.u) d / w, and x w = scale (u' - center) w is linear in u and n.
glm::dmat4 perspectiveMapping(const ViewMapping& m) {
  const Vec2 center = m.window.center();
  const Vec3& prp = m.projectionReferencePoint;
  const double scaleU = 2.0 / (m.window.uMax - m.window.uMin);
  const double scaleV = 2.0 / (m.window.vMax - m.window.vMin);
  const double d = prp.z - m.viewPlaneDistance;
  const double offU = prp.x - center.x, offV = prp.y - center.y;
  const double front = prp.z - m.frontPlaneDistance, back = prp.z - m.backPlaneDistance;
  const double slope = (front + back) / (back - front);  // of the depth over w
  const double shift = 2.0 * front * back / (back - front);
  return fromRows({scaleU * d, 0.0, -scaleU * offU, scaleU * (offU * prp.z - prp.x * d)},
                  {0.0, scaleV * d, -scaleV * offV, scaleV * (offV * prp.z - prp.y * d)},
                  {0.0, 0.0, -slope, slope * prp.z - shift}, {0.0, 0.0, -1.0, prp.z});
}

}  // namespace

ViewAxes viewAxes(const Vec3& vpn, const Vec3& vup) {
  const double length = glm::length(vpn);
  const Vec3 forward = length > 0.0 ? vpn / length : Vec3{0.0, 0.0, 1.0};
  Vec3 right = glm::cross(forward, vup);
  if (!(glm::length(right) > 1e-12 * glm::length(vup))) {
    right = glm::cross(forward, viewUpVector(forward, 0.0));
  }
  right = glm::normalize(right);
  return {right, glm::cross(right, forward), -forward};
}

glm::dmat4 viewOrientation(const Vec3& vrp, const ViewAxes& axes) {
  return fromRows({axes.u, -glm::dot(axes.u, vrp)}, {axes.v, -glm::dot(axes.v, vrp)},
                  {axes.n, -glm::dot(axes.n, vrp)}, {0.0, 0.0, 0.0, 1.0});
}

glm::dmat4 viewOrientation(const Vec3& vrp, const Vec3& vpn, const Vec3& vup) {
  return viewOrientation(vrp, viewAxes(vpn, vup));
}

tl::expected<glm::dmat4, ViewMappingError> viewMapping(const ViewMapping& mapping) {
  if (const auto error = errorIn(mapping)) return tl::unexpected(*error);
  return mapping.type == ProjectionType::Parallel ? parallelMapping(mapping)
                                                  : perspectiveMapping(mapping);
}

}  // namespace vides
