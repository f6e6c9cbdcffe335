// SPDX-License-Identifier: MIT
// Real speeds on both sides of a joint, and the value that makes them equal.
#include "evaluate/joint.hpp"

#include <algorithm>
#include <cmath>

#include "evaluate/quality.hpp"

namespace vides {
namespace {

// Speeds whose ratio is nearer to 1 are the same.
constexpr double kSame = 1e-3;

// Frames per frame that the section would take by rate and as it is: what a duration makes of all
// its speeds. 1 where there is none.
double pace(const Evaluation& evaluation, const Section& section) {
  const Flight& flight = evaluation.flight();
  const auto orientation = [&](const OrientationPlace& place) -> const Orientation& {
    return flight.keys[place.key].orientations[place.orientation];
  };
  const Orientation& from = orientation(section.from);
  if (!from.duration) return 1.0;
  double byRate = 0.0;
  switch (section.kind) {
    case SectionKind::kMove:
      byRate = flight.rates.move * section.length;
      break;
    case SectionKind::kPan:
      byRate = flight.rates.pan * section.angle / 180.0;
      break;
    case SectionKind::kRoll:
      byRate = flight.rates.roll * section.angle / 90.0;
      break;
    case SectionKind::kZoom:
      byRate = flight.rates.zoom * std::abs(orientation(section.to).zoom - from.zoom) / 99.0;
      break;
    case SectionKind::kHold:
      break;
  }
  const double mean = evaluation.speedCurve(section.from).mean();
  return byRate * kBaseSpeed / mean / std::max(1.0, *from.duration * flight.frameRate);
}

double changeOf(double a, double b) {
  const double most = std::max(a, b);
  return most < 1e-9 ? 0.0 : std::abs(b - a) / most;
}

// The measure of quality over the frame at a joint and its neighbours.
double changeAt(const Evaluation& evaluation, SectionKind kind, std::int64_t frame) {
  const std::int64_t all = evaluation.frameCount();
  const bool closed = evaluation.flight().closed;
  if (!closed && (frame < 1 || frame + 1 >= all)) return 1.0;
  const double fps = evaluation.flight().frameRate;
  QualityMeter meter(fps);
  double zoom[3] = {};
  for (int i = 0; i < 3; ++i) {
    const Frame at = evaluation.frame((frame - 1 + i + all) % all);
    meter.add(at);
    zoom[i] = at.camera.zoom;
  }
  if (kind == SectionKind::kMove) return meter.quality().maxSpeedJump;
  if (kind == SectionKind::kZoom) {
    return changeOf(std::abs(zoom[1] - zoom[0]) * fps, std::abs(zoom[2] - zoom[1]) * fps);
  }
  return meter.quality().maxAngularSpeedJump;
}

double endValue(const Evaluation& evaluation, const OrientationPlace& place, SectionEnd end) {
  const SpeedValues& values = evaluation.speedCurve(place).values();
  return end == SectionEnd::kStart ? values.front() : values.back();
}

Evaluation withValue(const Evaluation& evaluation, const OrientationPlace& place, SectionEnd end,
                     double value) {
  Flight flight = evaluation.flight();
  Key key = flight.keys[place.key];
  SpeedValues& speed = key.orientations[place.orientation].speed;
  (end == SectionEnd::kStart ? speed.front() : speed.back()) = value;
  flight.keys.set(place.key, std::move(key));
  return evaluation.updated(flight);
}

}  // namespace

Joint jointAt(const Evaluation& evaluation, const OrientationPlace& place, SectionEnd end) {
  Joint joint;
  const auto section = evaluation.sectionFrom(place);
  if (!section) return joint;
  const bool start = end == SectionEnd::kStart;
  const Evaluation::Beyond beyond = start ? evaluation.before(place) : evaluation.after(place);
  const SectionEnd otherEnd = start ? SectionEnd::kEnd : SectionEnd::kStart;
  if (beyond.section) joint.value = endValue(evaluation, *beyond.section, otherEnd);
  if (section->kind == SectionKind::kHold || (!beyond.section && !beyond.rests)) return joint;
  const auto other = beyond.section ? evaluation.sectionFrom(*beyond.section) : std::nullopt;
  if (!other || beyond.rests || other->kind == SectionKind::kHold) {
    joint.meeting = Joint::Meeting::kRests;
  } else if (other->kind != section->kind) {
    joint.meeting = Joint::Meeting::kOtherKind;
  } else {
    joint.meeting = Joint::Meeting::kGoesOn;
    const double own = endValue(evaluation, place, end);
    joint.asFast = *joint.value * pace(evaluation, *other) / pace(evaluation, *section);
    joint.jumps = changeOf(joint.asFast, own) > kSame;
  }
  const std::int64_t at = section->firstFrame + (start ? 0 : section->frames);
  joint.change = changeAt(evaluation, section->kind, at);
  return joint;
}

std::optional<double> matchingSpeed(const Evaluation& evaluation, const OrientationPlace& place,
                                    SectionEnd end) {
  const Joint here = jointAt(evaluation, place, end);
  if (here.meeting != Joint::Meeting::kGoesOn) return std::nullopt;
  // By how much the section beyond is faster. With the value the means of both curves change, too,
  // so that only trying tells; it falls as the value grows.
  const auto faster = [&](double value) {
    return jointAt(withValue(evaluation, place, end, value), place, end).asFast - value;
  };
  constexpr double kExact = 1e-6;
  const auto matches = [&](double value) { return std::abs(faster(value)) <= kExact * value; };
  double low = kMinSpeed, high = kMaxSpeed;
  for (const double likely : {here.value.value_or(low), low, high}) {
    if (matches(likely)) return likely;
  }
  if (faster(low) < 0.0 || faster(high) > 0.0) return std::nullopt;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (faster(middle) > 0.0 ? low : high) = middle;
  }
  for (double decimals = 1.0; decimals <= 1e6; decimals *= 10.0) {
    const double value = std::round(low * decimals) / decimals;
    if (matches(value)) return value;
  }
  return low;
}

}  // namespace vides
