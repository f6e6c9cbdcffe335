// SPDX-License-Identifier: MIT
// Edits of shapes, settings and space.
#include "edit/flight_edits.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "edit/key_values.hpp"

namespace vides {
namespace {

Edit changedFlight(const EditState& state, Text step, Flight flight) {
  return Edit{std::move(flight), std::move(step), state.marks};
}

Shape shapeFrom(const Arguments& arguments, std::size_t first) {
  return {arguments.number(first), arguments.number(first + 1), arguments.number(first + 2)};
}

// Rounding on the way through world coordinates must not push a key that stands on a face beyond
// it.
bool bringWithin(Vec3& position) {
  constexpr double kRounding = 1e-12;
  const Vec3 inside = glm::clamp(position, Vec3(-1.0), Vec3(1.0));
  if (glm::length(inside - position) > kRounding) return false;
  position = inside;
  return true;
}

// A length or place out of an `int`'s range is told by the check of the flight.
int pixels(double number) { return static_cast<int>(std::min(number, 1e9)); }

}  // namespace

EditResult setPresetEdit(const EditState& state, const Arguments& arguments) {
  const std::size_t preset = arguments.index(0);
  if (preset >= kPresets) return tl::unexpected(Text("refusal.preset", {preset}));
  auto edit = changeSelected(state, "step.set-preset", "step.set-presets",
                             [&](Key& key, std::size_t) -> std::optional<Text> {
                               key.shape.preset = static_cast<int>(preset);
                               key.shape.own = {};
                               return std::nullopt;
                             });
  if (edit) edit->step.parts.emplace_back(preset);
  return edit;
}

EditResult setShapeEdit(const EditState& state, const Arguments& arguments) {
  return changeSelected(state, "step.set-shape", "step.set-shapes",
                        [&](Key& key, std::size_t) -> std::optional<Text> {
                          key.shape.preset = KeyShape::kOwn;
                          key.shape.own = shapeFrom(arguments, 0);
                          return std::nullopt;
                        });
}

EditResult setTensionEdit(const EditState& state, const Arguments& arguments) {
  return setInSelected(state, KeyValue::kTension, arguments.value(0));
}

EditResult setContinuityEdit(const EditState& state, const Arguments& arguments) {
  return setInSelected(state, KeyValue::kContinuity, arguments.value(0));
}

EditResult setBiasEdit(const EditState& state, const Arguments& arguments) {
  return setInSelected(state, KeyValue::kBias, arguments.value(0));
}

EditResult setPresetShapeEdit(const EditState& state, const Arguments& arguments) {
  const std::size_t preset = arguments.index(0);
  if (preset >= kPresets) return tl::unexpected(Text("refusal.preset", {preset}));
  Flight flight = state.flight;
  flight.presets[preset] = shapeFrom(arguments, 1);
  return changedFlight(state, Text("step.set-preset-shape", {preset}), std::move(flight));
}

EditResult setNameEdit(const EditState& state, const Arguments& arguments) {
  Flight flight = state.flight;
  flight.name = arguments.text(0);
  return changedFlight(state, "step.set-name", std::move(flight));
}

EditResult setFrameRateEdit(const EditState& state, const Arguments& arguments) {
  Flight flight = state.flight;
  flight.frameRate = arguments.number(0);
  return changedFlight(state, "step.set-frame-rate", std::move(flight));
}

EditResult setPictureEdit(const EditState& state, const Arguments& arguments) {
  Flight flight = state.flight;
  flight.picture.width = pixels(arguments.number(0));
  flight.picture.height = pixels(arguments.number(1));
  return changedFlight(state, "step.set-picture", std::move(flight));
}

EditResult setLensEdit(const EditState& state, const Arguments& arguments) {
  Flight flight = state.flight;
  flight.lens = {arguments.number(0), arguments.number(1), arguments.number(2)};
  return changedFlight(state, "step.set-lens", std::move(flight));
}

EditResult setRatesEdit(const EditState& state, const Arguments& arguments) {
  Flight flight = state.flight;
  flight.rates = {arguments.number(0), arguments.number(1), arguments.number(2),
                  arguments.number(3)};
  return changedFlight(state, "step.set-rates", std::move(flight));
}

EditResult setClosedEdit(const EditState& state, const Arguments& arguments) {
  Flight flight = state.flight;
  flight.closed = arguments.text(0) == "on" || (arguments.text(0) == "toggle" && !flight.closed);
  return changedFlight(state, flight.closed ? "step.close" : "step.open", std::move(flight));
}

EditResult setOrientationCurveEdit(const EditState& state, const Arguments& arguments) {
  Flight flight = state.flight;
  // The command's arguments are checked: it is one of them.
  for (const OrientationCurve curve : kOrientationCurves) {
    if (name(curve) == arguments.text(0)) flight.orientationCurve = curve;
  }
  return changedFlight(state, "step.set-orientation-curve", std::move(flight));
}

tl::expected<Flight, Text> inSpace(const Flight& flight, const Space& space) {
  if (space == flight.space) return flight;
  Flight result = flight;
  result.space = space;
  if (!(space.halfSize > 0.0)) return result;  // told by the check of the flight
  const double growth = space.halfSize / flight.space.halfSize;
  result.rates.move *= growth;
  std::size_t outside = 0;
  std::vector<KeyPointer> keys;
  keys.reserve(flight.keys.size());
  flight.keys.forEach([&](const Key& from) {
    Key key = from;
    key.position = space.toCube(flight.space.toWorld(from.position));
    if (!bringWithin(key.position)) ++outside;
    for (Orientation& o : key.orientations) {
      o.aim = o.aimMode == AimMode::kAbsolute ? space.toCube(flight.space.toWorld(o.aim))
                                              : o.aim / growth;
    }
    keys.emplace_back(std::move(key));
  });
  if (outside > 0) return tl::unexpected(Text("refusal.space-too-small", {outside}));
  result.keys = KeyList(keys);
  return result;
}

Space spaceAround(const Space& space, const Vec3& point) {
  const Vec3 size = glm::abs(point);
  const double reach = std::max({size.x, size.y, size.z});
  if (reach <= 1.0) return space;
  return {space.center, space.halfSize * reach * 1.05};
}

EditResult setSpaceEdit(const EditState& state, const Arguments& arguments) {
  auto flight = inSpace(state.flight, {arguments.point(0), arguments.number(3)});
  if (!flight) return tl::unexpected(flight.error());
  return changedFlight(state, "step.set-space", std::move(*flight));
}

}  // namespace vides
