// SPDX-License-Identifier: MIT
// Dragging a key or an aim in a plane or along an axis (5-editor, "Dragging a point").
//
// Everything is computed from the state at the press and where the pointer is now.
#pragma once

#include <optional>

#include <tl/expected.hpp>

#include "edit/edit_state.hpp"
#include "math/plane_drag.hpp"
#include "scene/viewport_scene.hpp"

namespace vides {

class PlaneDragTool {
 public:
  enum class What { kKey, kAim };

  // `start` is the state at the press, whose current key (or current orientation's aim) is dragged;
  // with several keys selected they move along. `pointer` is where the point was taken hold of: a
  // point that is dragged by its own handle lies under the pointer from the first move on, one that
  // is dragged by a plane square keeps its distance (`keepDistance`).
  PlaneDragTool(EditState start, What what, const ViewProjection& view, const Vec2& pointer,
                Axis constant, bool keepDistance);

  // X, Y, Z during a drag: along that axis, then with that coordinate kept, then the button's
  // plane.
  void cycle(Axis axis);
  // Goes on in another view of the same point; false where the point can't be seen in it.
  bool look(const ViewProjection& view);
  // To multiples of `step`, a multiple of 1e-6.
  void setSnap(std::optional<double> step) { snap_ = step; }

  // The flight with the point under the pointer.
  tl::expected<Flight, DragRefusal> at(const Vec2& pointer) const;

  // Where the dragged point is for a pointer, and what it moves in: for drawing.
  tl::expected<Vec3, DragRefusal> pointAt(const Vec2& pointer) const;
  std::optional<Axis> constant() const;  // nothing while it moves along one axis
  Text way() const;                      // the same in words
  // Its name in "Undo …".
  Text step() const;

 private:
  enum class Constraint { kButton, kAxis, kPlane };
  bool moves(int coordinate) const;
  tl::expected<Vec3, DragRefusal> free(const Vec2& pointer) const;
  Vec3 snapped(Vec3 point) const;
  Vec3 withinCube(const Vec3& point) const;
  Vec3 alongFreeAxis(const Vec3& clamped, const Vec3& wanted, const Vec2& pointer) const;

  EditState start_;
  What what_;
  Grab grab_;
  Axis button_;
  Constraint constraint_ = Constraint::kButton;
  Axis axis_ = Axis::X;
  std::optional<double> snap_;
};

// The text that tells why nothing moves.
Text textOf(DragRefusal refusal);

}  // namespace vides
