// SPDX-License-Identifier: MIT
// Dividing a move, a pan, a roll, a zoom or a hold at one of its moments.
#include "evaluate/division.hpp"

#include <algorithm>
#include <cmath>

#include "evaluate/film_keeper.hpp"
#include "evaluate/look_as.hpp"
#include "evaluate/timed_parts.hpp"
#include "flight/limits.hpp"

namespace vides {
namespace {

// Places, angles and aims that differ by less are one.
constexpr double kSame = 1e-9;

// The moment at which a section is divided.
struct Moment {
  Section section;
  std::int64_t frames = 0;  // of the first half
  double time = 0.0;        // in the section's frames; the whole number `frames`, or near it
  Camera camera;
};

const Orientation& orientationAt(const Flight& flight, const OrientationPlace& place) {
  return flight.keys[place.key].orientations[place.orientation];
}

// The distance at which an aim stands from its key: the old one's, but near enough that its
// coordinates are within the file's range, and far enough that they tell the VPN to 1e-10.
double reachOf(const Orientation& o, const Camera& camera, double distance) {
  const bool absolute = o.aimMode == AimMode::kAbsolute;
  double reach = std::max(distance, absolute ? 1e-6 : 2.0 * limits::kAimDistance);
  for (int i = 0; i < 3; ++i) {
    const double room = limits::kAim.max - (absolute ? 1.0 : 0.0);
    const double part = std::abs(camera.viewPlaneNormal[i]);
    if (part * reach > room) reach = room / part;
  }
  return reach;
}

// What the camera sees at the moment, as an orientation of `key`, which stands there.
Orientation orientationAtMoment(const Flight& flight, const Moment& moment, const Key& key) {
  const Orientation& old = orientationAt(flight, moment.section.from);
  const Vec3 offset = aimOffset(flight.keys[moment.section.from.key], old);
  const Vec3& vpn = moment.camera.viewPlaneNormal;
  Orientation o = old;
  o.hold = 0.0;
  o.extra.reset();
  // The old aim stays where the camera looks to it, as in a tracking move: typed numbers remain.
  const Vec3 toAim = aimOffset(key, o);
  const double distance = glm::length(toAim);
  if (distance >= limits::kAimDistance && glm::length(toAim / distance - vpn) < 1e-12) {
    o.roll = rollOf(moment.camera, key, o);
    o.zoom = moment.camera.zoom;
  } else {
    lookAs(moment.camera, key, reachOf(o, moment.camera, glm::length(offset)), o);
  }
  // Of the rolls that look alike the one next to the old one's way.
  const double change =
      std::remainder(orientationAt(flight, moment.section.to).roll - old.roll, 360.0);
  const double expected = old.roll + 0.5 * change;
  o.roll = expected + std::remainder(o.roll - expected, 360.0);
  if (std::abs(o.roll - old.roll) < 1e-9) o.roll = old.roll;
  while (o.roll > limits::kRoll.max) o.roll -= 360.0;
  while (o.roll < limits::kRoll.min) o.roll += 360.0;
  return o;
}

// Where an orientation stands when one has been inserted.
struct Shift {
  OrientationPlace inserted;
  bool key = false;  // a key has been, else an orientation
  OrientationPlace operator()(OrientationPlace place) const {
    if (key && place.key >= inserted.key) {
      ++place.key;
    } else if (!key && place.key == inserted.key && place.orientation >= inserted.orientation) {
      ++place.orientation;
    }
    return place;
  }
};

// A whole section beside the divided one.
void addNeighbour(const Evaluation& evaluation, const std::optional<Section>& section,
                  const Section& divided, const Shift& shift, DividedFilm& film) {
  if (!section || section->from == divided.from) return;
  if (section->kind == SectionKind::kHold) return;
  const bool byRate = !orientationAt(evaluation.flight(), section->from).duration;
  const OrientationPlace place = shift(section->from);
  for (const Course& known : film.neighbours) {
    if (known.place == place) return;
  }
  film.neighbours.push_back(
      {place, section->frames, evaluation.speedCurve(section->from), 0.0, 1.0, byRate});
}

void addNeighbours(const Evaluation& evaluation, const Section& divided, const Shift& shift,
                   DividedFilm& film) {
  for (const auto& beyond : {evaluation.before(divided.from), evaluation.after(divided.from)}) {
    if (beyond.section) {
      addNeighbour(evaluation, evaluation.sectionFrom(*beyond.section), divided, shift, film);
    }
  }
  if (!shift.key) return;
  // The pieces of the curve that end and begin at its keys bend.
  const KeyList& keys = evaluation.flight().keys;
  const bool closed = evaluation.flight().closed;
  const auto addPiece = [&](std::size_t key) {
    const OrientationPlace from{key, keys[key].orientations.size() - 1};
    const auto section = evaluation.sectionFrom(from);
    if (section && section->kind == SectionKind::kMove) {
      addNeighbour(evaluation, section, divided, shift, film);
    }
  };
  const std::size_t k = divided.from.key;
  if (k > 0 || closed) addPiece((k + keys.size() - 1) % keys.size());
  addPiece(divided.to.key);
}

// With the new key or orientation in its place, the halves' frames to be settled.
tl::expected<Division, DivisionRefusal> divided(const Evaluation& evaluation, const Moment& moment,
                                                const Shift& shift, Flight flight) {
  const Section& section = moment.section;
  const SpeedCurve& speed = evaluation.speedCurve(section.from);
  const auto frames = static_cast<double>(section.frames);
  DividedFilm film;
  film.flight = std::move(flight);
  film.place = shift.inserted;
  film.frame = section.firstFrame + moment.frames;
  film.halves[0] = {section.from, moment.frames, speed, 0.0, moment.time / frames};
  film.halves[1] = {film.place, section.frames - moment.frames, speed, moment.time / frames, 1.0};
  film.duration = orientationAt(evaluation.flight(), section.from).duration;
  addNeighbours(evaluation, section, shift, film);
  auto kept = keepFilm(evaluation, film);
  if (!kept) return tl::unexpected(DivisionRefusal::kOneFrame);
  return Division{std::move(*kept), film.place};
}

tl::expected<Division, DivisionRefusal> withKey(const Evaluation& evaluation,
                                                const Moment& moment) {
  const Flight& flight = evaluation.flight();
  if (flight.keys.size() >= limits::kKeys.max) {
    return tl::unexpected(DivisionRefusal::kTooManyKeys);
  }
  const Vec3& point = moment.camera.viewReferencePoint;
  Key key;
  key.position = glm::clamp(point, Vec3(-1.0), Vec3(1.0));
  if (glm::length(key.position - point) > kSame) {
    return tl::unexpected(DivisionRefusal::kOutsideCube);
  }
  key.orientations = {orientationAtMoment(flight, moment, key)};
  const Shift shift{{moment.section.from.key + 1, 0}, true};
  Flight result = flight;
  result.keys.insert(shift.inserted.key, std::move(key));
  return divided(evaluation, moment, shift, std::move(result));
}

tl::expected<Division, DivisionRefusal> withOrientation(const Evaluation& evaluation,
                                                        const Moment& moment) {
  const Flight& flight = evaluation.flight();
  const OrientationPlace from = moment.section.from;
  Key key = flight.keys[from.key];
  if (key.orientations.size() >= kMostOrientations) {
    return tl::unexpected(DivisionRefusal::kTooManyOrientations);
  }
  const Shift shift{{from.key, from.orientation + 1}, false};
  const bool rests = moment.section.from == moment.section.to;
  Orientation o = rests || moment.section.kind == SectionKind::kHold
                      ? key.orientations[from.orientation]
                      : orientationAtMoment(flight, moment, key);
  o.extra.reset();
  Orientation& first = key.orientations[from.orientation];
  if (rests) {
    // The second half is the hold before the section, the first one before nothing.
    first.duration.reset();
    const double hold = first.hold;
    const double rate = flight.frameRate;
    first.hold = static_cast<double>(moment.frames) / rate;
    o.hold = std::max(hold - first.hold, 0.5 / rate);
  } else {
    o.hold = 0.0;
  }
  const double whole = flight.keys[from.key].orientations[from.orientation].hold;
  key.orientations.insert(
      key.orientations.begin() + static_cast<std::ptrdiff_t>(shift.inserted.orientation),
      std::move(o));
  Flight result = flight;
  result.keys.set(from.key, std::move(key));
  if (!rests) return divided(evaluation, moment, shift, std::move(result));
  settleTimedParts(result, evaluation.updated(result),
                   {{from, true, moment.frames, std::nullopt},
                    {shift.inserted, true, moment.section.frames - moment.frames, whole}});
  return Division{std::move(result), shift.inserted};
}

tl::expected<Division, DivisionRefusal> divideAt(const Evaluation& evaluation,
                                                 const Moment& moment) {
  return moment.section.kind == SectionKind::kMove ? withKey(evaluation, moment)
                                                   : withOrientation(evaluation, moment);
}

// The time at which the share of the way is done.
double timeOf(const SpeedCurve& speed, double share) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (speed.progress(middle) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

tl::expected<Moment, DivisionRefusal> momentAt(const Evaluation& evaluation, std::size_t piece,
                                               double fraction) {
  if (piece >= evaluation.pieceCount()) return tl::unexpected(DivisionRefusal::kNoSuchPiece);
  const KeyList& keys = evaluation.flight().keys;
  const auto section = evaluation.sectionFrom({piece, keys[piece].orientations.size() - 1});
  const double length = evaluation.pieceLength(piece);
  if (!section || section->kind != SectionKind::kMove ||
      std::min(fraction, 1.0 - fraction) * length < kSame) {
    return tl::unexpected(DivisionRefusal::kKeyIsThere);
  }
  Moment moment;
  moment.section = *section;
  const auto frames = static_cast<double>(section->frames);
  moment.time = frames * timeOf(evaluation.speedCurve(section->from), fraction);
  // On a frame it is the frame's camera to the last bit.
  const double near = std::round(moment.time);
  if (std::abs(moment.time - near) < 1e-7 && near > 0.0 && near < frames) moment.time = near;
  moment.camera = evaluation.cameraBetween(static_cast<double>(section->firstFrame) + moment.time);
  if (section->frames < 2) return moment;
  moment.frames = std::clamp<std::int64_t>(std::llround(moment.time), 1, section->frames - 1);
  return moment;
}

}  // namespace

tl::expected<Division, DivisionRefusal> divideAtFrame(const Evaluation& evaluation,
                                                      std::int64_t frame) {
  if (frame < 0 || frame >= evaluation.frameCount()) {
    return tl::unexpected(DivisionRefusal::kFlightEnds);
  }
  const auto section = evaluation.sectionAtFrame(frame);
  if (!section) return tl::unexpected(DivisionRefusal::kNothingHappens);
  Moment moment;
  moment.section = *section;
  moment.frames = frame - section->firstFrame;
  if (moment.frames == 0) return tl::unexpected(DivisionRefusal::kSectionBegins);
  if (moment.frames >= section->frames) return tl::unexpected(DivisionRefusal::kFlightEnds);
  moment.time = static_cast<double>(moment.frames);
  moment.camera = evaluation.frame(frame).camera;
  return divideAt(evaluation, moment);
}

tl::expected<Division, DivisionRefusal> divideAtPlace(const Evaluation& evaluation,
                                                      std::size_t piece, double fraction) {
  const auto moment = momentAt(evaluation, piece, fraction);
  if (!moment) return tl::unexpected(moment.error());
  if (moment->section.frames < 2) return tl::unexpected(DivisionRefusal::kOneFrame);
  return divideAt(evaluation, *moment);
}

Camera cameraAtPlace(const Evaluation& evaluation, std::size_t piece, double fraction) {
  const auto moment = momentAt(evaluation, piece, fraction);
  return moment ? moment->camera : Camera{};
}

}  // namespace vides
