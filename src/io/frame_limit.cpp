// SPDX-License-Identifier: MIT
// Bounds the frames of a flight without evaluating it.
#include "io/frame_limit.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "evaluate/evaluation.hpp"
#include "flight/limits.hpp"
#include "math/kochanek_bartels.hpp"
#include "math/speed_curve.hpp"

namespace vides {
namespace {

// For what rounding may add to sums and lengths.
constexpr double kSafety = 1.0 + 1e-6;

// The control polygon is at least as long as the curve.
double lengthBound(const CubicSegment& piece) {
  const Vec3 p0 = piece.point(0.0);
  const Vec3 p3 = piece.point(1.0);
  const Vec3 p1 = p0 + piece.derivative(0.0) / 3.0;
  const Vec3 p2 = p3 - piece.derivative(1.0) / 3.0;
  return glm::distance(p0, p1) + glm::distance(p1, p2) + glm::distance(p2, p3);
}

double pieceLengthBound(const std::vector<const Key*>& keys, const Flight& flight, std::size_t k) {
  const std::size_t n = keys.size();
  const Key& from = *keys[k];
  const Key& to = *keys[(k + 1) % n];
  const bool first = k == 0 && !flight.closed;
  const bool last = k + 2 >= n && !flight.closed;
  const Vec3* before = first ? nullptr : &keys[(k + n - 1) % n]->position;
  const Vec3* after = last ? nullptr : &keys[(k + 2) % n]->position;
  return lengthBound(kochanekBartelsSegment(before, from.position, shapeOf(flight, from),
                                            to.position, shapeOf(flight, to), after));
}

// The mean of a speed curve is the trapezoid rule over its values and (m_0 - m_9)/12, whatever
// stands beside it; a limited slope is at most three times the range of speeds.
double slowestMean(const SpeedValues& speed) {
  double sum = (speed.front() + speed.back()) / 2.0;
  for (std::size_t i = 1; i + 1 < speed.size(); ++i) sum += speed[i];
  constexpr double kMostSlope = 3.0 * (kMaxSpeed - kMinSpeed);
  return std::max(kMinSpeed, (sum - 2.0 * kMostSlope / 12.0) / (kSpeedValues - 1));
}

// Frames of the hold and the section that an orientation begins; `length` bounds the curve's.
double framesBound(const Flight& flight, const Orientation& o, double length) {
  const double hold = o.hold * flight.frameRate + 1.0;
  if (o.duration) return hold + *o.duration * flight.frameRate + 1.0;
  // A pan measures at most 1 (90 degrees of half the rotation angle), a roll 2, a zoom 1.
  const Rates& rates = flight.rates;
  const double work =
      std::max({rates.move * length, rates.pan, 2.0 * rates.roll, rates.zoom}) * kBaseSpeed;
  return hold + work / slowestMean(o.speed) + 1.0;
}

}  // namespace

double frameCountBound(const Flight& flight) {
  std::vector<const Key*> keys;
  keys.reserve(flight.keys.size());
  flight.keys.forEach([&](const Key& key) { keys.push_back(&key); });
  double frames = 1.0;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const std::vector<Orientation>& orientations = keys[k]->orientations;
    const bool end = k + 1 == keys.size() && !flight.closed;
    for (std::size_t i = 0; i < orientations.size(); ++i) {
      const bool leaves = i + 1 == orientations.size() && !end;
      const double length = leaves ? pieceLengthBound(keys, flight, k) : 0.0;
      frames += framesBound(flight, orientations[i], length);
    }
  }
  return frames * kSafety;
}

std::optional<Problem> checkFrameCount(const Flight& flight) {
  constexpr auto kMost = static_cast<double>(limits::kFrames);
  if (frameCountBound(flight) <= kMost) return std::nullopt;
  const std::int64_t frames = Evaluation(flight).frameCount();
  if (frames <= static_cast<std::int64_t>(limits::kFrames)) return std::nullopt;
  Problem problem;
  problem.code = ProblemCode::kTooManyFrames;
  problem.pointer = "/keys";
  problem.expected.max = kMost;
  problem.found = std::to_string(frames);
  return problem;
}

}  // namespace vides
