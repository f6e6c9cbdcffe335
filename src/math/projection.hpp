// SPDX-License-Identifier: MIT
// The viewing pipeline of PHIGS (paper, chapter 2): view orientation and view mapping as matrices.
//
// World coordinates are right-handed, y up. View reference coordinates (VRC) have their origin at
// the VRP and the axes u (right), v (up) and n (towards the viewer). Our VPN is the viewing
// direction; PHIGS' view plane normal is n = -VPN. What the viewer sees lies at smaller n than he
// does.
// Clip coordinates are OpenGL's: after division by w, the window is [-1, 1] x [-1, 1] with y up,
// the front plane lies at -1, the back plane at 1. In perspective w is the distance from the PRP
// along -n, positive in front of it; in parallel projection w is 1. Matrices multiply column
// vectors: clip = mapping * orientation * world.
#pragma once

#include <glm/mat4x4.hpp>
#include <tl/expected.hpp>

#include "math/vector.hpp"

namespace vides {

// Right, up and back (u, v, n) in world coordinates: a right-handed orthonormal base.
struct ViewAxes {
  Vec3 u{-1.0, 0.0, 0.0};
  Vec3 v{0.0, 1.0, 0.0};
  Vec3 n{0.0, 0.0, -1.0};
};

// The axes of a view along `vpn` (any length but 0) in which `vup` points up. Formed by cross
// products, so that no direction is special. Where `vup` lies along `vpn` (sine below 1e-12) or is
// zero, the VUP of roll 0 takes its place. A zero `vpn` counts as the rest direction, +z.
ViewAxes viewAxes(const Vec3& vpn, const Vec3& vup);

// World to view reference coordinates.
glm::dmat4 viewOrientation(const Vec3& vrp, const ViewAxes& axes);
glm::dmat4 viewOrientation(const Vec3& vrp, const Vec3& vpn, const Vec3& vup);

enum class ProjectionType { Parallel, Perspective };

// A rectangle on the view plane, in VRC.
struct ViewWindow {
  double uMin = -1.0, uMax = 1.0;
  double vMin = -1.0, vMax = 1.0;
  Vec2 center() const { return {0.5 * (uMin + uMax), 0.5 * (vMin + vMax)}; }
  bool operator==(const ViewWindow&) const = default;
};

// All in VRC. The projection reference point is the eye of a perspective; in a parallel projection
// the rays run along the line from it to the window's center: orthographic where that line is
// parallel to n, oblique otherwise.
struct ViewMapping {
  ProjectionType type = ProjectionType::Parallel;
  ViewWindow window;
  Vec3 projectionReferencePoint{0.0, 0.0, 1.0};
  double viewPlaneDistance = 0.0;   // n of the plane that holds the window
  double frontPlaneDistance = 1.0;  // n; greater than the back plane's, for n faces the viewer
  double backPlaneDistance = -1.0;
  bool operator==(const ViewMapping&) const = default;
};

enum class ViewMappingError {
  EmptyWindow,  // uMin < uMax and vMin < vMax do not hold
  BackPlaneNotBehindFrontPlane,
  ReferencePointOnViewPlane,
  ReferencePointNotBeforeFrontPlane,  // perspective only
};

// View reference to clip coordinates.
tl::expected<glm::dmat4, ViewMappingError> viewMapping(const ViewMapping& mapping);

}  // namespace vides
