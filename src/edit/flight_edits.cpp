// SPDX-License-Identifier: MIT
// Edits of shapes, settings, space and scene.
#include "edit/flight_edits.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace vides {
namespace {

Edit changedFlight(const EditState& state, Text step, Flight flight) {
  return Edit{std::move(flight), std::move(step), state.marks};
}

// The current key's shape becomes its own, with something changed.
template <class Change>
Edit ownShape(const EditState& state, Change change) {
  Key key = state.key();
  Shape shape = shapeOf(state.flight, key);
  change(shape);
  key.shape.preset = KeyShape::kOwn;
  key.shape.own = shape;
  return Edit{withKey(state.flight, state.current().key, std::move(key)),
              Text("step.set-shape", {state.current().key + 1}), state.marks};
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
  Key key = state.key();
  key.shape.preset = static_cast<int>(preset);
  key.shape.own = {};
  return Edit{withKey(state.flight, state.current().key, std::move(key)),
              Text("step.set-preset", {state.current().key + 1, preset}), state.marks};
}

EditResult setShapeEdit(const EditState& state, const Arguments& arguments) {
  return ownShape(state, [&](Shape& shape) { shape = shapeFrom(arguments, 0); });
}

EditResult setTensionEdit(const EditState& state, const Arguments& arguments) {
  return ownShape(state, [&](Shape& shape) { shape.tension = arguments.number(0); });
}

EditResult setContinuityEdit(const EditState& state, const Arguments& arguments) {
  return ownShape(state, [&](Shape& shape) { shape.continuity = arguments.number(0); });
}

EditResult setBiasEdit(const EditState& state, const Arguments& arguments) {
  return ownShape(state, [&](Shape& shape) { shape.bias = arguments.number(0); });
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
  flight.orientationCurve = orientationMethod(arguments.text(0));  // checked before
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

EditResult addSceneEdit(const EditState& state, const Arguments& arguments) {
  Flight flight = state.flight;
  const bool first = flight.scene.empty() && flight.space == Space{};
  SceneFile scene;
  scene.file = arguments.text(0);
  flight.scene.push_back(std::move(scene));
  if (first && arguments.has(6)) {
    const Vec3 low = arguments.point(1), high = arguments.point(4);
    const Vec3 extent = high - low;
    const double size = 0.5 * std::max({extent.x, extent.y, extent.z});
    if (size < 0.0) return tl::unexpected(Text("refusal.scene-box"));
    flight.space.center = 0.5 * (low + high);
    // A scene that is a single point has no size to fit.
    if (size > 0.0) flight.space.halfSize = size / 0.8;
  }
  return changedFlight(state, Text("step.add-scene", {arguments.text(0)}), std::move(flight));
}

EditResult removeSceneEdit(const EditState& state, const Arguments& arguments) {
  const std::size_t index = arguments.index(0);
  if (index >= state.flight.scene.size()) {
    return tl::unexpected(Text("refusal.no-such-scene", {index + 1, state.flight.scene.size()}));
  }
  Flight flight = state.flight;
  const std::string file = flight.scene[index].file;
  flight.scene.erase(flight.scene.begin() + static_cast<std::ptrdiff_t>(index));
  return changedFlight(state, Text("step.remove-scene", {file}), std::move(flight));
}

}  // namespace vides
