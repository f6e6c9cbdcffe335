// SPDX-License-Identifier: MIT
// Stages 1 and 2 of the evaluator's records: curve, differences, speed, frames.
#include "evaluate/records.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/quaternion.hpp"

namespace vides {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
// Lengths, directions and rolls that differ by less count as equal.
constexpr double kSame = 1e-9;
// Quaternions whose product is smaller are perpendicular: neither sign is nearer.
constexpr double kPerpendicular = 1e-9;

// Shorter durations count as this many frames, so that work never underflows.
constexpr double kLeastFrames = 1e-100;

// Halves go up, also where rounding errors push them just below.
std::int64_t roundedFrames(double frames) {
  return static_cast<std::int64_t>(std::floor(frames + 0.5 + 1e-9));
}

Quaternion orientationOf(const Key& key, const Orientation& orientation) {
  return quaternionFrom(glm::normalize(aimOffset(key, orientation)), orientation.roll * kDegree);
}

double dot(const Quaternion& a, const Quaternion& b) {
  return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
}

SignLink linkBetween(const Quaternion& a, const Quaternion& b) {
  const double d = dot(a, b);
  if (d > kPerpendicular) return SignLink::kKeep;
  return d < -kPerpendicular ? SignLink::kFlip : SignLink::kReset;
}

bool trackOnePoint(const Key& keyA, const Orientation& a, const Key& keyB, const Orientation& b) {
  return a.aimMode == AimMode::kAbsolute && b.aimMode == AimMode::kAbsolute &&
         glm::length(aimPoint(keyA, a) - aimPoint(keyB, b)) < kSame;
}

// What differs between orientation a and the next one, b; the first kind that applies.
void setDifferences(const Flight& flight, const KeyRecord& record, bool keysDiffer, const Key& keyA,
                    const Orientation& a, const Key& keyB, const Orientation& b, SectionRecord& s) {
  s.qEnd = orientationOf(keyB, b);
  s.zoomEnd = b.zoom;
  s.positionEnd = keyB.position;
  s.link = linkBetween(s.q, s.qEnd);
  s.rollChange = std::remainder(b.roll - a.roll, 360.0);
  const double length = keysDiffer ? record.piece->length : 0.0;
  if (length > kSame) {
    s.kind = SectionKind::kMove;
    s.workByRate = kBaseSpeed * flight.rates.move * length;
    s.tracking = trackOnePoint(keyA, a, keyB, b);
  } else if (glm::length(viewPlaneNormal(s.q) - viewPlaneNormal(s.qEnd)) > kSame) {
    s.kind = SectionKind::kPan;
    const double measure = halfRotationAngle(s.q, s.qEnd) / (90.0 * kDegree);
    s.workByRate = kBaseSpeed * flight.rates.pan * measure;
  } else if (std::abs(s.rollChange) * kDegree > kSame) {
    s.kind = SectionKind::kRoll;
    s.workByRate = kBaseSpeed * flight.rates.roll * std::abs(s.rollChange) / 90.0;
  } else if (a.zoom != b.zoom) {
    s.kind = SectionKind::kZoom;
    s.workByRate = kBaseSpeed * flight.rates.zoom * std::abs(b.zoom - a.zoom) / 99.0;
  }
  if (a.duration) {
    s.durationFrames = std::max(*a.duration * flight.frameRate, kLeastFrames);
    s.timedLength = FrameSum::partsOf(std::max(1.0, s.durationFrames));
  }
  s.exists = s.kind != SectionKind::kHold || a.duration.has_value();
}

std::shared_ptr<const CurvePiece> makePiece(const Flight& flight, const Key* before, const Key& key,
                                            const Key& next, const Key* afterNext,
                                            const std::shared_ptr<const CurvePiece>& reuse,
                                            const std::shared_ptr<CurvePiece>& piece) {
  piece->curve = kochanekBartelsSegment(before ? &before->position : nullptr, key.position,
                                        shapeOf(flight, key), next.position, shapeOf(flight, next),
                                        afterNext ? &afterNext->position : nullptr);
  if (reuse && reuse->curve == piece->curve) return reuse;
  piece->coincident = glm::length(next.position - key.position) < kCoincident;
  if (!piece->coincident) {
    piece->arc = ArcLength(piece->curve);
    piece->length = piece->arc.length();
  }
  return piece;
}

}  // namespace

void fillRecord(KeyRecord& record, const Flight& flight, const Key* before, const Key& key,
                const Key* next, const Key* afterNext,
                const std::shared_ptr<const CurvePiece>& reuse,
                const std::shared_ptr<CurvePiece>& piece) {
  record.position = key.position;
  if (next) record.piece = makePiece(flight, before, key, *next, afterNext, reuse, piece);
  const std::size_t count = key.orientations.size();
  record.sections.resize(count);
  for (std::size_t j = 0; j < count; ++j) {
    const Orientation& a = key.orientations[j];
    SectionRecord& s = record.sections[j];
    s.q = orientationOf(key, a);
    s.zoom = s.zoomEnd = a.zoom;
    s.roll = a.roll;
    s.aim = aimPoint(key, a);
    const double hold = a.hold * flight.frameRate;
    if (roundedFrames(hold) >= 1) s.holdLength = FrameSum::partsOf(hold);
    s.speed = SpeedCurve(a.speed);
    s.qEnd = s.q;
    s.positionEnd = key.position;
    if (j + 1 < count) {
      setDifferences(flight, record, false, key, a, key, key.orientations[j + 1], s);
    } else if (next) {
      setDifferences(flight, record, true, key, a, *next, next->orientations.front(), s);
    }
  }
}

void setSpeed(SectionRecord& s, std::optional<double> before, std::optional<double> after) {
  s.speed = SpeedCurve(s.speed.values(), before, after);
  const double mean = s.speed.mean();
  if (s.timedLength > 0) {
    s.work = s.durationFrames * mean;
  } else {
    s.work = s.workByRate;
    s.framesByRate = std::max<std::int64_t>(1, roundedFrames(s.workByRate / mean));
  }
}

RecordSummary RecordSummary::of(const KeyRecord& record, std::size_t orientation) {
  const SectionRecord& s = record.sections[orientation];
  RecordSummary sum;
  sum.signs = SignMap::of(s.link);
  if (s.holds()) {
    sum.frames = s.ofHold();
    sum.entries = 1;
    sum.vanishingHolds = s.holdMayVanish() ? 1 : 0;
  }
  if (s.exists) {
    sum.frames = sum.frames + s.ofSection();
    ++sum.entries;
    sum.sections = 1;
    sum.length = static_cast<FixedPoint>(std::ldexp(record.lengthOf(s), 60));
  }
  return sum;
}

RecordSummary RecordSummary::of(const RecordPointer& record) {
  RecordSummary sum = of(*record, 0);
  for (std::size_t j = 1; j < record->sections.size(); ++j) sum = sum + of(*record, j);
  return sum;
}

}  // namespace vides
