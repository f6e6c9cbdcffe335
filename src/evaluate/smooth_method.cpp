// SPDX-License-Identifier: MIT
// The method `smooth`: spherical cubic Béziers with limited, continuous angular velocity; moves
// that look at one point keep looking at it.
#include <algorithm>
#include <cmath>

#include "evaluate/orientation_path.hpp"

namespace vides {
namespace {

// Below this share of the length a tangent counts as zero.
constexpr double kNoTangent = 1e-9;
// The camera stands on its aim: no direction is defined.
constexpr double kOnAim = 1e-9;
// Looking straight up or down: yaw and pitch rates are not defined.
constexpr double kPole = 1e-7;

// A move that keeps looking at one point: VPN from the position, roll by a cubic in the progress.
struct TrackingPath {
  Vec3 aim{0.0};            // cube coordinates
  double rollStart = 0.0;   // radians
  double rollChange = 0.0;  // radians
  double slopeStart = 0.0;  // d roll / d progress at both ends, radians
  double slopeEnd = 0.0;
  Quaternion start{1.0, 0.0, 0.0, 0.0};  // taken where the camera stands on the aim

  ViewDirection at(const PathContext& context) const;
};

ViewDirection TrackingPath::at(const PathContext& context) const {
  const double t = context.progress;
  if (t == 0.0) return viewDirection(start);
  const Vec3 toAim = aim - context.position;
  const double d = glm::length(toAim);
  if (d < kOnAim) return viewDirection(start);
  const Vec3 n = toAim / d;
  const double t2 = t * t;
  const double t3 = t2 * t;
  const double roll = rollStart + rollChange * (3.0 * t2 - 2.0 * t3) +
                      slopeStart * (t3 - 2.0 * t2 + t) + slopeEnd * (t3 - t2);
  return {n, viewUpVector(n, roll)};
}

Vec3 shortened(const Vec3& v, double most) {
  const double size = glm::length(v);
  return size > most ? v * (most / size) : v;
}

double shortened(double v, double most) { return std::clamp(v, -most, most); }

// The direction of travel at an end of the curve, also where the tangent vanishes.
Vec3 travelDirection(const PathSection& s, bool atEnd) {
  const double u = atEnd ? 1.0 : 0.0;
  const double tiny = kNoTangent * s.length;
  Vec3 t = s.curve->derivative(u);
  if (glm::length(t) <= tiny) {
    t = s.curve->secondDerivative(u);
    if (atEnd) t = -t;
    if (glm::length(t) <= tiny) t = s.curve->thirdDerivative();
  }
  const double size = glm::length(t);
  return size > 0.0 ? t / size : Vec3(0.0);
}

// omega = Omega / 2 of a tracking move at one of its ends, per unit of work.
Vec3 trackingTurnRate(const PathSection& s, bool atEnd) {
  const Vec3 position = s.curve->point(atEnd ? 1.0 : 0.0);
  const Vec3 toAim = s.aim - position;
  const double d = glm::length(toAim);
  if (d < kOnAim) return Vec3(0.0);
  const Vec3 n = toAim / d;
  const double across = std::hypot(n.x, n.z);
  if (across < kPole) return Vec3(0.0);
  const Vec3 t = travelDirection(s, atEnd);
  const Vec3 change = -(t - n * glm::dot(n, t)) * (s.length / (s.work * d));
  const double yawRate = (n.z * change.x - n.x * change.z) / (n.x * n.x + n.z * n.z);
  const double pitchRate = -change.y / across;
  const Vec3 pitchAxis(n.z / across, 0.0, -n.x / across);
  return 0.5 * (Vec3(0.0, yawRate, 0.0) + pitchRate * pitchAxis + s.rollRate() * n);
}

// The angular velocity that two neighbouring sections share at their joint, for the controls of the
// one that does not track.
Vec3 jointTurnRate(const PathSection& before, const PathSection& after, bool rests) {
  if (rests) return Vec3(0.0);
  if (before.tracking) {
    if (after.still()) return Vec3(0.0);
    return shortened(trackingTurnRate(before, true), glm::length(after.turnRate()));
  }
  if (after.tracking) {
    if (before.still()) return Vec3(0.0);
    return shortened(trackingTurnRate(after, false), glm::length(before.turnRate()));
  }
  if (before.still() || after.still()) return Vec3(0.0);
  const Vec3 a = before.turnRate();
  const Vec3 b = after.turnRate();
  const Vec3 mean = (after.work * a + before.work * b) / (before.work + after.work);
  return shortened(mean, std::min(glm::length(a), glm::length(b)));
}

// The rate of roll that a tracking move has at a joint (its own where `other` does not track).
double jointRollRate(const PathSection& own, const std::optional<PathSection>& other, bool rests) {
  if (rests) return 0.0;
  const double rate = own.rollRate();
  if (!other || !other->tracking) return rate;
  const double otherRate = other->rollRate();
  const double mean = (own.work * otherRate + other->work * rate) / (own.work + other->work);
  return shortened(mean, std::min(std::abs(rate), std::abs(otherRate)));
}

OrientationPath trackingPath(const PathInput& in) {
  const PathSection& s = in.section;
  TrackingPath path;
  path.aim = s.aim;
  path.start = s.start;
  path.rollStart = s.rollStart;
  path.rollChange = s.rollChange;
  path.slopeStart = s.work * jointRollRate(s, in.previous, in.restsBefore);
  path.slopeEnd = s.work * jointRollRate(s, in.next, in.restsAfter);
  return OrientationPath(path);
}

OrientationPath bezierPath(const PathInput& in) {
  const PathSection& s = in.section;
  const bool still = s.still();
  Quaternion after = s.start;
  Quaternion before = s.end;
  if (in.previous) {
    const Vec3 rate = jointTurnRate(*in.previous, s, in.restsBefore);
    after = exp(rate * (s.work / 3.0)) * s.start;
  }
  if (in.next) {
    const Vec3 rate = jointTurnRate(s, *in.next, in.restsAfter);
    before = exp(rate * (-s.work / 3.0)) * s.end;
  }
  if (!in.previous && !still && !in.restsBefore) {
    after = in.next ? slerp(s.start, before, 0.5) : slerp(s.start, s.end, 1.0 / 3.0);
  }
  if (!in.next && !still && !in.restsAfter) {
    before = in.previous ? slerp(s.end, after, 0.5) : slerp(s.start, s.end, 2.0 / 3.0);
  }
  return OrientationPath(TurningPath{SphericalBezier(s.start, after, before, s.end)});
}

OrientationPath make(const PathInput& in) {
  return in.section.tracking ? trackingPath(in) : bezierPath(in);
}

}  // namespace

extern const OrientationMethod kSmoothMethod{.name = "smooth", .tracks = true, .make = make};

}  // namespace vides
