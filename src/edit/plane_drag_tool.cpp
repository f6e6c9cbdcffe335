// SPDX-License-Identifier: MIT
// The plane drag: constraint, grid and cube around the mathematics of math/plane_drag.hpp.
#include "edit/plane_drag_tool.hpp"

#include <algorithm>
#include <cmath>

#include "edit/key_edits.hpp"
#include "edit/orientation_edits.hpp"
#include "flight/limits.hpp"

namespace vides {

Text textOf(DragRefusal refusal) {
  switch (refusal) {
    case DragRefusal::PlaneXEdgeOn:
      return "refusal.plane-edge-on.x";
    case DragRefusal::PlaneYEdgeOn:
      return "refusal.plane-edge-on.y";
    case DragRefusal::PlaneZEdgeOn:
      return "refusal.plane-edge-on.z";
    case DragRefusal::AxisXEndOn:
      return "refusal.axis-end-on.x";
    case DragRefusal::AxisYEndOn:
      return "refusal.axis-end-on.y";
    case DragRefusal::AxisZEndOn:
      return "refusal.axis-end-on.z";
    case DragRefusal::NotInFront:
      return "refusal.not-in-front";
    case DragRefusal::BeyondHorizon:
      return "refusal.beyond-horizon";
  }
  return {};
}

PlaneDragTool::PlaneDragTool(EditState start, What what, const ViewProjection& view,
                             const Vec2& pointer, Axis constant, bool keepDistance)
    : start_(std::move(start)), what_(what), button_(constant) {
  grab_.view = view;
  grab_.point =
      what == What::kKey ? start_.key().position : aimPoint(start_.key(), start_.orientation());
  grab_.pointer = pointer;
  if (const auto seen = view.project(grab_.point); seen && !keepDistance) grab_.pointer = *seen;
}

void PlaneDragTool::cycle(Axis axis) {
  if (constraint_ == Constraint::kButton || axis_ != axis) {
    constraint_ = Constraint::kAxis;
  } else {
    constraint_ = constraint_ == Constraint::kAxis ? Constraint::kPlane : Constraint::kButton;
  }
  axis_ = axis;
}

bool PlaneDragTool::look(const ViewProjection& view) {
  const auto before = grab_.view.project(grab_.point), now = view.project(grab_.point);
  if (!before || !now) return false;
  grab_.pointer += *now - *before;
  grab_.view = view;
  return true;
}

std::optional<Axis> PlaneDragTool::constant() const {
  if (constraint_ == Constraint::kAxis) return std::nullopt;
  return constraint_ == Constraint::kPlane ? axis_ : button_;
}

Text PlaneDragTool::way() const {
  const std::optional<Axis> kept = constant();
  const char letter = "xyz"[static_cast<int>(kept.value_or(axis_))];
  return std::string(kept ? "hint.plane." : "drag.along.") + letter;
}

bool PlaneDragTool::moves(int coordinate) const {
  const auto axis = static_cast<Axis>(coordinate);
  return constraint_ == Constraint::kAxis ? axis == axis_ : axis != *constant();
}

tl::expected<Vec3, DragRefusal> PlaneDragTool::free(const Vec2& pointer) const {
  if (constraint_ == Constraint::kAxis) return dragAlongAxis(grab_, axis_, pointer);
  return dragInPlane(grab_, *constant(), pointer);
}

Vec3 PlaneDragTool::snapped(Vec3 point) const {
  if (!snap_) return point;
  for (int i = 0; i < 3; ++i) {
    // A whole number of millionths, divided: that gives the decimals that are typed.
    if (moves(i)) point[i] = std::round(std::round(point[i] / *snap_) * *snap_ * 1e6) / 1e6;
  }
  return point;
}

Vec3 PlaneDragTool::withinCube(const Vec3& point) const {
  if (what_ == What::kAim) {
    return glm::clamp(point, Vec3(limits::kAim.min), Vec3(limits::kAim.max));
  }
  const Vec3 wanted = point - grab_.point;
  const Vec3 offset = offsetWithinCube(start_.flight, start_.marks.selected, wanted);
  Vec3 result = point;  // exactly, where nothing stops it
  for (int i = 0; i < 3; ++i) {
    if (offset[i] == wanted[i]) continue;
    // On a face exactly, where it is this key that reaches it.
    const double face = offset[i] < wanted[i] ? 1.0 : -1.0;
    const bool reached = offset[i] == face - grab_.point[i];
    result[i] = reached ? face : std::clamp(grab_.point[i] + offset[i], -1.0, 1.0);
  }
  return result;
}

// Where one of two moving coordinates is stopped, the other one still follows the pointer.
Vec3 PlaneDragTool::alongFreeAxis(const Vec3& clamped, const Vec3& wanted,
                                  const Vec2& pointer) const {
  int stopped = 0, left = -1;
  for (int i = 0; i < 3; ++i) {
    if (!moves(i)) continue;
    if (clamped[i] != wanted[i]) {
      ++stopped;
    } else {
      left = i;
    }
  }
  if (stopped != 1 || left < 0) return clamped;
  const auto seen = grab_.view.project(clamped);
  const auto held = grab_.view.project(grab_.point);
  if (!seen || !held) return clamped;
  // The distance from point to pointer that the drag keeps.
  const Vec2 target = pointer - (grab_.pointer - *held);
  const auto moved = dragAlongAxis({grab_.view, clamped, *seen}, static_cast<Axis>(left), target);
  return moved ? withinCube(*moved) : clamped;
}

tl::expected<Vec3, DragRefusal> PlaneDragTool::pointAt(const Vec2& pointer) const {
  const auto point = free(pointer);
  if (!point) return point;
  const Vec3 wanted = snapped(*point);
  const Vec3 clamped = withinCube(wanted);
  if (snap_ || clamped == wanted) return clamped;
  return alongFreeAxis(clamped, wanted, pointer);
}

tl::expected<Flight, DragRefusal> PlaneDragTool::at(const Vec2& pointer) const {
  const auto point = pointAt(pointer);
  if (!point) return tl::unexpected(point.error());
  const KeySelection& selected = start_.marks.selected;
  const Vec3 offset = *point - grab_.point;
  Flight flight = start_.flight;
  if (what_ == What::kAim) {
    if (selected.size() > 1) flight = withMovedAims(start_, selected, offset);
    // The one that is held lies exactly where it should.
    Key key = flight.keys[start_.current().key];
    setAimPoint(key, key.orientations[start_.current().orientation], *point);
    flight.keys.set(start_.current().key, std::move(key));
    return flight;
  }
  if (selected.size() > 1) flight = withMovedKeys(flight, selected, offset);
  Key key = flight.keys[start_.current().key];
  key.position = *point;
  flight.keys.set(start_.current().key, std::move(key));
  return flight;
}

Text PlaneDragTool::step() const {
  const std::size_t count = start_.marks.selected.size();
  const std::size_t key = start_.current().key + 1;
  if (what_ == What::kAim) {
    return count > 1 ? Text("step.move-aims", {count}) : Text("step.set-aim", {key});
  }
  return count > 1 ? Text("step.move-keys", {count}) : Text("step.move-key", {key});
}

}  // namespace vides
