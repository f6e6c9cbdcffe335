// SPDX-License-Identifier: MIT
// Speeds between neighbouring frames, and how they change.
#include "evaluate/quality.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vides {
namespace {

constexpr double kStill = 1e-9;       // speeds below don't count as jumps
constexpr double kCube = 1.0 + 1e-9;  // as far as a coordinate may go

double jump(double before, double after) {
  const double larger = std::max(before, after);
  return larger < kStill ? 0.0 : std::abs(after - before) / larger;
}

bool outsideCube(const Vec3& p) {
  return std::abs(p.x) > kCube || std::abs(p.y) > kCube || std::abs(p.z) > kCube;
}

// a x b of nearly equal vectors without cancellation.
Vec3 crossOfNear(const Vec3& a, const Vec3& b) { return glm::cross(a, b - a); }

}  // namespace

double rotationBetween(const Camera& a, const Camera& b) {
  const Vec3& na = a.viewPlaneNormal;
  const Vec3& nb = b.viewPlaneNormal;
  const Vec3& ua = a.viewUpVector;
  const Vec3& ub = b.viewUpVector;
  const Vec3 ra = glm::cross(na, ua);
  const Vec3 rb = glm::cross(nb, ub);
  // Of the rotation that takes one to the other: 2 sin(angle) axis, and its trace 1 + 2 cos(angle).
  const Vec3 axis = crossOfNear(ra, rb) + crossOfNear(ua, ub) + crossOfNear(na, nb);
  const double trace = glm::dot(ra, rb) + glm::dot(ua, ub) + glm::dot(na, nb);
  return std::atan2(glm::length(axis), trace - 1.0);
}

void QualityMeter::add(const Frame& frame) {
  if (outsideCube(frame.camera.viewReferencePoint)) ++quality_.framesOutsideCube;
  if (frames_ >= 1) {
    const double speed =
        frameRate_ * glm::length(frame.camera.viewReferencePoint - before_.viewReferencePoint);
    const double turn =
        frameRate_ * rotationBetween(before_, frame.camera) * 180.0 / std::numbers::pi;
    quality_.maxSpeed = std::max(quality_.maxSpeed, speed);
    quality_.maxAngularSpeed = std::max(quality_.maxAngularSpeed, turn);
    if (frames_ >= 2) {
      quality_.maxSpeedJump = std::max(quality_.maxSpeedJump, jump(speed_, speed));
      quality_.maxAngularSpeedJump = std::max(quality_.maxAngularSpeedJump, jump(turn_, turn));
    }
    speed_ = speed;
    turn_ = turn;
  }
  before_ = frame.camera;
  ++frames_;
}

Quality measureQuality(const Evaluation& evaluation) {
  return measureQuality(evaluation, 0, evaluation.frameCount());
}

Quality measureQuality(const Evaluation& evaluation, std::int64_t first, std::int64_t last) {
  QualityMeter meter(evaluation.flight().frameRate);
  // A jump is between three frames. What the two before measure belongs to the part before: the
  // greatest of all is none the worse for it, but frames outside are counted once.
  const std::int64_t from = std::max<std::int64_t>(0, first - 2);
  FrameWalk walk(evaluation, from, last);
  Frame frame;
  while (walk.position() < first && walk.next(frame)) meter.add(frame);
  const std::int64_t outsideBefore = meter.quality().framesOutsideCube;
  while (walk.next(frame)) meter.add(frame);
  Quality quality = meter.quality();
  quality.framesOutsideCube -= outsideBefore;
  return quality;
}

Quality together(const Quality& a, const Quality& b) {
  return {std::max(a.maxSpeed, b.maxSpeed), std::max(a.maxAngularSpeed, b.maxAngularSpeed),
          std::max(a.maxSpeedJump, b.maxSpeedJump),
          std::max(a.maxAngularSpeedJump, b.maxAngularSpeedJump),
          a.framesOutsideCube + b.framesOutsideCube};
}

}  // namespace vides
