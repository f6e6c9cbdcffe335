// SPDX-License-Identifier: MIT
// Turning, panning, sizing and framing the view.
#include "edit/view_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vides {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
// One step of the wheel: four of them a bit more than double.
constexpr double kWheelFactor = 1.2;
constexpr double kLeastRadius = 0.5 * kCubeRadius;

// From the view's target along its axes.
ViewAxes axesOf(const EditorView& view) { return viewProjection(view, PixelRectangle{}).axes(); }

}  // namespace

Vec3 withinReach(Vec3 place) {
  for (int i = 0; i < 3; ++i) {
    place[i] = std::isnan(place[i]) ? 0.0 : std::clamp(place[i], -kFarthestPlace, kFarthestPlace);
  }
  return place;
}

std::optional<NamedView> namedView(std::string_view name) {
  if (name == "iso") return NamedView{32.0, 22.0};
  if (name == "front") return NamedView{0.0, 0.0};
  if (name == "side") return NamedView{90.0, 0.0};
  if (name == "top") return NamedView{0.0, 90.0};
  return std::nullopt;
}

EditorView limited(EditorView view) {
  if (view.turn < -180.0 || view.turn > 180.0) view.turn = std::remainder(view.turn, 360.0);
  view.tilt = std::clamp(view.tilt, -90.0, 90.0);
  view.size = std::clamp(view.size, kMinViewSize, kMaxViewSize);
  view.target = withinReach(view.target);
  return view;
}

EditorView turnedTo(const EditorView& view, const Vec3& pivot, double turn, double tilt) {
  EditorView turned = view;
  turned.turn = turn;
  turned.tilt = tilt;
  turned = limited(turned);
  const ViewAxes before = axesOf(view), after = axesOf(turned);
  const Vec3 offset = view.target - pivot;
  turned.target = pivot + glm::dot(offset, before.u) * after.u +
                  glm::dot(offset, before.v) * after.v + glm::dot(offset, before.n) * after.n;
  if (view.target == pivot) turned.target = pivot;
  return limited(turned);
}

EditorView turnedAbout(const EditorView& view, const Vec3& pivot, double turnBy, double tiltBy) {
  return turnedTo(view, pivot, view.turn + turnBy, view.tilt + tiltBy);
}

EditorView opposite(const EditorView& view, const Vec3& pivot) {
  return turnedTo(view, pivot, view.turn + 180.0, -view.tilt);
}

EditorView panned(const EditorView& view, const PixelRectangle& pixels, const Vec2& by) {
  const ViewProjection projection = viewProjection(view, pixels);
  const glm::dmat3x2 perUnit = projection.jacobian(view.target);
  const ViewAxes& axes = projection.axes();
  EditorView moved = view;
  moved.target -= axes.u * (by.x / (perUnit * axes.u).x);
  moved.target -= axes.v * (by.y / (perUnit * axes.v).y);
  return limited(moved);
}

EditorView sizedTowards(const EditorView& view, const PixelRectangle& pixels, const Vec2& pointer,
                        double steps) {
  EditorView sized = view;
  sized.size *= std::pow(kWheelFactor, steps);
  sized = limited(sized);
  // What lies under the pointer is `offset` from the middle: it must be `size` ratio times farther.
  const Vec2 middle{pixels.x + 0.5 * pixels.width, pixels.y + 0.5 * pixels.height};
  const EditorView underPointer = panned(view, pixels, middle - pointer);
  const Vec3 offset = underPointer.target - view.target;
  sized.target = view.target + offset * (1.0 - view.size / sized.size);
  return limited(sized);
}

EditorView framed(const EditorView& view, const Vec3& low, const Vec3& high) {
  const double radius = 0.5 * glm::length(high - low) * 1.1;
  EditorView result = view;
  result.target = 0.5 * (low + high);
  result.size = kCubeRadius / std::max(radius, kLeastRadius);
  return limited(result);
}

}  // namespace vides
