// SPDX-License-Identifier: MIT
// Moves a point with the pointer in a plane x, y or z = const, or along one axis (paper 6.2.1).
//
// Pure functions of the state at the press: never sums of steps. The point's projection moves with
// the pointer, so where a drag is not refused, the offset between the two stays what it was at the
// press.
#pragma once

#include <tl/expected.hpp>

#include "math/view_projection.hpp"

namespace vides {

enum class Axis { X = 0, Y = 1, Z = 2 };

// Why nothing moves.
enum class DragRefusal {
  PlaneXEdgeOn,  // the plane x = const is seen edge-on: turn or tilt the view
  PlaneYEdgeOn,
  PlaneZEdgeOn,
  AxisXEndOn,  // the x axis is seen end-on
  AxisYEndOn,
  AxisZEndOn,
  NotInFront,     // the point lies behind the viewer of a perspective
  BeyondHorizon,  // in perspective: the plane or axis is nowhere under the pointer
};

// Less than this and a plane counts as edge-on, an axis as end-on.
inline constexpr double kEdgeOnPixelsPerUnit = 10.0;

// What a drag is computed from.
struct Grab {
  ViewProjection view;
  Vec3 point{0.0};    // where it was at the press
  Vec2 pointer{0.0};  // where the pointer was
};

// The point in the plane through its place at the press in which the coordinate `constant` keeps
// its value. Parallel: the closed formula; perspective: the pointer's ray meets the plane.
tl::expected<Vec3, DragRefusal> dragInPlane(const Grab& grab, Axis constant, const Vec2& pointer);

// The point along one axis whose projection comes closest to the pointer.
tl::expected<Vec3, DragRefusal> dragAlongAxis(const Grab& grab, Axis free, const Vec2& pointer);

// The smaller singular value of the matrix with the columns a and b.
double smallestSingularValue(const Vec2& a, const Vec2& b);

}  // namespace vides
