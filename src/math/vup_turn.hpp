// SPDX-License-Identifier: MIT
// Turns the VUP about the VPN so that it is seen pointing towards the pointer (paper 6.2.3).
#pragma once

#include <tl/expected.hpp>

#include "math/view_projection.hpp"

namespace vides {

// Why the VUP stays.
enum class TurnRefusal {
  CircleEdgeOn,     // the circle of its tip is seen edge-on: turn or tilt the view
  NotInFront,       // the VRP lies behind the viewer of a perspective
  PointerAtCenter,  // the pointer lies on the VRP's projection and shows no direction
};

// The roll in radians, in [-pi, pi], of a camera at `vrp` that looks along the unit direction
// `vpn`, for which the VUP's projection points from the projected VRP towards the pointer. Found by
// the paper's bisection on the projected circle, to 1e-14. The circle counts as edge-on as a plane
// does in math/plane_drag.hpp.
tl::expected<double, TurnRefusal> rollTowards(const ViewProjection& view, const Vec3& vrp,
                                              const Vec3& vpn, const Vec2& pointer);

}  // namespace vides
