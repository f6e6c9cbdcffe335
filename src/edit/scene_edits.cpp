// SPDX-License-Identifier: MIT
// Scenes come and go, and the space is fitted to them.
#include "edit/scene_edits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "edit/flight_edits.hpp"
#include "math/projection.hpp"

namespace vides {
namespace {

Edit changedFlight(const EditState& state, Text step, Flight flight) {
  return Edit{std::move(flight), std::move(step), state.marks};
}

double halfSizeOf(const BoundingBox& box) {
  // Halved first: also where the difference would be beyond a double.
  const Vec3 half = 0.5 * box.high - 0.5 * box.low;
  return std::max({half.x, half.y, half.z});
}

// The longest focal length that shows all of a box from a place, looking at a point.
double longestFocalLength(const Flight& flight, const Vec3& place, const Vec3& aim,
                          const BoundingBox& box) {
  const ViewAxes axes = viewAxes(aim - place, {0.0, 1.0, 0.0});
  const double proportion =
      static_cast<double>(flight.picture.height) / static_cast<double>(flight.picture.width);
  const double half = 0.5 * flight.lens.sensorWidth;
  double longest = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at((corner & 1) != 0 ? box.high.x : box.low.x,
                  (corner & 2) != 0 ? box.high.y : box.low.y,
                  (corner & 4) != 0 ? box.high.z : box.low.z);
    const Vec3 from = at - place;
    const double ahead = -glm::dot(from, axes.n);
    if (ahead <= 0.0) return 0.0;
    longest = std::min({longest, half * ahead / std::abs(glm::dot(from, axes.u)),
                        half * proportion * ahead / std::abs(glm::dot(from, axes.v))});
  }
  return longest;
}

// The largest zoom that has this focal length or a shorter one; where none has, the widest.
double zoomWithin(const Lens& lens, double focal) {
  constexpr double kMost = 12.0;
  const double growth = lens.focalLength(kMost) - lens.focalLength(kMinZoom);
  if (lens.focalLength(kMost) <= focal || growth <= 0.0) return kMost;
  double zoom = kMinZoom + (kMost - kMinZoom) * (focal - lens.focalLength(kMinZoom)) / growth;
  zoom = std::clamp(zoom, kMinZoom, kMost);
  while (zoom > kMinZoom && lens.focalLength(zoom) > focal) zoom = std::nextafter(zoom, 0.0);
  return zoom;
}

// Two keys before a box that is in the cube's middle.
KeyList keysAround(const Flight& flight, const BoundingBox& box) {
  const Vec3 middle = flight.space.toCube(0.5 * box.low + 0.5 * box.high);
  const BoundingBox inCube{flight.space.toCube(box.low), flight.space.toCube(box.high)};
  Key keys[2];
  keys[0].position = {-0.5, 0.3, 0.8};
  keys[1].position = {0.5, 0.3, 0.8};
  double focal = std::numeric_limits<double>::infinity();
  for (const Key& key : keys) {
    focal = std::min(focal, longestFocalLength(flight, key.position, middle, inCube));
  }
  const double zoom = zoomWithin(flight.lens, focal);
  for (Key& key : keys) {
    key.orientations.front().aim = middle;
    key.orientations.front().zoom = zoom;
  }
  return KeyList{keys[0], keys[1]};
}

}  // namespace

Text noSuchScene(const Flight& flight, std::size_t index) {
  return Text("refusal.no-such-scene", {index + 1, flight.scene.size()});
}

bool takesFirstScene(const Flight& flight) {
  return flight.scene.empty() && flight.space == Space{};
}

Space fittedSpace(const Space& space, const BoundingBox& box, double share) {
  const double size = halfSizeOf(box);
  return {0.5 * box.low + 0.5 * box.high, size > 0.0 ? size / share : space.halfSize};
}

EditResult addSceneEdit(const EditState& state, const Arguments& arguments) {
  Flight flight = state.flight;
  const bool first = takesFirstScene(flight);
  SceneFile scene;
  scene.file = arguments.text(0);
  // The command's arguments are checked: it is one of them.
  if (arguments.has(7)) scene.up = *upAxis(arguments.text(7));
  flight.scene.push_back(std::move(scene));
  if (first && arguments.has(6)) {
    const BoundingBox box{arguments.point(1), arguments.point(4)};
    if (halfSizeOf(box) < 0.0) return tl::unexpected(Text("refusal.scene-box"));
    flight.space = fittedSpace(flight.space, box, kImportShare);
  }
  return changedFlight(state, Text("step.add-scene", {arguments.text(0)}), std::move(flight));
}

EditResult removeSceneEdit(const EditState& state, const Arguments& arguments) {
  const std::size_t index = arguments.index(0);
  if (index >= state.flight.scene.size()) {
    return tl::unexpected(noSuchScene(state.flight, index));
  }
  Flight flight = state.flight;
  const std::string file = flight.scene[index].file;
  flight.scene.erase(flight.scene.begin() + static_cast<std::ptrdiff_t>(index));
  return changedFlight(state, Text("step.remove-scene", {file}), std::move(flight));
}

EditResult showSceneEdit(const EditState& state, const Arguments& arguments) {
  const std::size_t index = arguments.index(0);
  if (index >= state.flight.scene.size()) {
    return tl::unexpected(noSuchScene(state.flight, index));
  }
  Flight flight = state.flight;
  SceneFile& scene = flight.scene[index];
  const bool toggles = !arguments.has(1) || arguments.text(1) == "toggle";
  scene.visible = toggles ? !scene.visible : arguments.text(1) == "on";
  const char* const step = scene.visible ? "step.show-scene" : "step.hide-scene";
  return changedFlight(state, Text(step, {scene.file}), std::move(flight));
}

EditResult fitSpaceEdit(const EditState& state, const BoundingBox& box, double share) {
  if (!kFitShares.contains(share)) return tl::unexpected(Text("refusal.fit-share", {share}));
  const Space space = fittedSpace(state.flight.space, box, share);
  if (state.flight.keys == newFlight().keys) {
    Flight flight = state.flight;
    flight.space = space;
    flight.keys = keysAround(flight, box);
    return changedFlight(state, "step.fit-space", std::move(flight));
  }
  auto flight = inSpace(state.flight, space);
  if (!flight) return tl::unexpected(flight.error());
  return changedFlight(state, "step.fit-space", std::move(*flight));
}

}  // namespace vides
