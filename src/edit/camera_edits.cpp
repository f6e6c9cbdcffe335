// SPDX-License-Identifier: MIT
// From cameras to orientations and keys.
#include "edit/camera_edits.hpp"

#include <algorithm>

#include "edit/flight_edits.hpp"
#include "evaluate/look_as.hpp"

namespace vides {
namespace {

// Closer than this and rounding would turn the VPN; farther than this and an aim may be too far.
constexpr double kNearestAim = 0.01;
constexpr double kFarthestAim = 1e5;
// A place that differs by less is the same.
constexpr double kSamePlace = 1e-9;

// The distance at which a new aim stands: the current one's.
double aimDistance(const EditState& state) {
  const double distance = glm::length(aimOffset(state.key(), state.orientation()));
  return std::clamp(distance, kNearestAim, kFarthestAim);
}

tl::unexpected<Text> outside() { return tl::unexpected(Text("refusal.outside-cube")); }

}  // namespace

bool insideCube(const Camera& camera) {
  const Vec3 size = glm::abs(camera.viewReferencePoint);
  return std::max({size.x, size.y, size.z}) <= 1.0;
}

tl::expected<Flight, Text> enlargedFor(const Flight& flight, Camera& camera) {
  const Space space = spaceAround(flight.space, camera.viewReferencePoint);
  auto result = inSpace(flight, space);
  if (result) {
    camera.viewReferencePoint = space.toCube(flight.space.toWorld(camera.viewReferencePoint));
  }
  return result;
}

EditResult useView(const EditState& state, const Camera& camera) {
  if (!insideCube(camera)) return outside();
  Key key = state.key();
  if (glm::length(camera.viewReferencePoint - key.position) > kSamePlace) {
    key.position = camera.viewReferencePoint;
  }
  lookAs(camera, key, aimDistance(state), key.orientations[state.current().orientation]);
  return Edit{withKey(state.flight, state.current().key, std::move(key)),
              Text("step.use-view", {state.current().key + 1}), state.marks};
}

EditResult newKeyFromView(const EditState& state, const Camera& camera) {
  if (!insideCube(camera)) return outside();
  const std::size_t at = state.current().key + 1;
  const std::size_t size = state.flight.keys.size();
  Key before = state.key();
  Key key;
  key.position = camera.viewReferencePoint;
  key.shape = before.shape;
  key.orientations = {state.orientation()};
  Orientation& o = key.orientations.front();
  o.hold = 0.0;
  o.duration = before.orientations.back().duration;
  o.speed = before.orientations.back().speed;
  o.extra.reset();
  lookAs(camera, key, aimDistance(state), o);

  Edit edit{state.flight, Text("step.new-key-from-view", {at + 1}), marksAt({at, 0})};
  if (o.duration && (at < size || state.flight.closed)) {
    const Vec3 next = state.flight.keys[at % size].position;
    const double there = glm::length(key.position - before.position);
    const double onward = glm::length(next - key.position);
    const double share = there + onward > 0.0 ? there / (there + onward) : 0.5;
    // Both parts stay above 0.
    const double first = *o.duration * std::clamp(share, 1e-9, 1.0 - 1e-9);
    before.orientations.back().duration = first;
    o.duration = *o.duration - first;
    edit.flight.keys.set(at - 1, std::move(before));
  } else {
    o.duration.reset();
  }
  edit.flight.keys.insert(at, std::move(key));
  return edit;
}

}  // namespace vides
