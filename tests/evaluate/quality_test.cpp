// SPDX-License-Identifier: MIT
// Measures of quality: hand-made frames, and flights whose speeds are known.
#include "evaluate/quality.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "math/quaternion.hpp"

namespace vides {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Camera cameraOf(const Quaternion& q) {
  Camera camera;
  camera.viewPlaneNormal = viewPlaneNormal(q);
  camera.viewUpVector = viewUpVector(q);
  return camera;
}

Quaternion turn(const Vec3& axis, double angle) {
  return {std::cos(angle / 2.0), std::sin(angle / 2.0) * glm::normalize(axis)};
}

Quality measure(const std::vector<Camera>& cameras, double frameRate) {
  QualityMeter meter(frameRate);
  Frame frame;
  for (const Camera& camera : cameras) {
    frame.camera = camera;
    meter.add(frame);
    ++frame.number;
  }
  return meter.quality();
}

Camera at(double x, double y = 0.0, double z = 0.0) {
  Camera camera;
  camera.viewReferencePoint = {x, y, z};
  return camera;
}

TEST(Quality, RotationIsTheFullAngle) {
  std::mt19937_64 random{3};
  std::normal_distribution<double> normal;
  for (int i = 0; i < 10'000; ++i) {
    const double w = normal(random), x = normal(random), y = normal(random);
    const Quaternion q = glm::normalize(Quaternion(w, x, y, normal(random)));
    const Vec3 axis{normal(random), normal(random), w};
    for (const double angle : {1e-3, 0.1, 1.0, 2.0, 3.0, 3.14159, std::numbers::pi}) {
      EXPECT_NEAR(rotationBetween(cameraOf(q), cameraOf(turn(axis, angle) * q)), angle, 1e-14);
    }
  }
}

TEST(Quality, TinyRotationsKeepTheirDigits) {
  // About the rest camera's own axes, where the vectors hold the angle to the last bit.
  for (const double angle : {1e-6, 1e-9, 1e-12, 1e-15}) {
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      const Camera turned = cameraOf(turn(axis, angle));
      EXPECT_NEAR(rotationBetween(Camera{}, turned) / angle, 1.0, 1e-12) << angle;
    }
  }
  EXPECT_EQ(rotationBetween(Camera{}, Camera{}), 0.0);
}

TEST(Quality, SpeedIsPerSecond) {
  const Quality q = measure({at(0), at(0.01), at(0.03), at(0.03, 0.01)}, 50.0);
  EXPECT_NEAR(q.maxSpeed, 1.0, 1e-12);
  EXPECT_NEAR(q.maxSpeedJump, 0.5, 1e-12);  // 0.5 to 1.0 and back
  EXPECT_EQ(q.maxAngularSpeed, 0.0);
  EXPECT_EQ(q.maxAngularSpeedJump, 0.0);
  EXPECT_EQ(q.framesOutsideCube, 0);
}

TEST(Quality, TurnsAreDegreesPerSecond) {
  std::vector<Camera> cameras;
  for (const double degrees : {0.0, 1.0, 4.0, 7.0}) {
    cameras.push_back(cameraOf(turn({0, 1, 0}, degrees * kDegree)));
  }
  const Quality q = measure(cameras, 25.0);
  EXPECT_NEAR(q.maxAngularSpeed, 75.0, 1e-10);
  EXPECT_NEAR(q.maxAngularSpeedJump, 2.0 / 3.0, 1e-12);
  EXPECT_EQ(q.maxSpeed, 0.0);
}

TEST(Quality, StartsAndStopsAreWholeJumpsAndRestIsNone) {
  EXPECT_DOUBLE_EQ(measure({at(0), at(0), at(0.1)}, 25.0).maxSpeedJump, 1.0);
  EXPECT_DOUBLE_EQ(measure({at(0), at(0.1), at(0.1)}, 25.0).maxSpeedJump, 1.0);
  EXPECT_EQ(measure({at(0), at(0), at(1e-12), at(1e-12)}, 25.0).maxSpeedJump, 0.0);
}

TEST(Quality, CountsFramesOutsideTheCube) {
  const Quality q =
      measure({at(1.0), at(1.0 + 5e-10), at(1.0 + 2e-9), at(0, -1.5), at(0, 0, 1.1)}, 25.0);
  EXPECT_EQ(q.framesOutsideCube, 3);
}

TEST(Quality, OneFrameHasNoSpeed) {
  const Quality q = measure({at(3.0)}, 25.0);
  EXPECT_EQ(q.maxSpeed, 0.0);
  EXPECT_EQ(q.framesOutsideCube, 1);
}

// A straight line at base speed: 100 frames per cube unit at 25 frames per second.
TEST(Quality, OfAFlight) {
  Flight flight = newFlight();
  for (std::size_t i = 0; i < 2; ++i) {
    Key key = flight.keys[i];
    key.orientations.front().aim = {0.0, 0.0, -1.0};
    key.orientations.front().aimMode = AimMode::kRelative;
    flight.keys.set(i, key);
  }
  const Quality q = measureQuality(Evaluation(flight));
  EXPECT_NEAR(q.maxSpeed, 0.25, 1e-9);
  EXPECT_LT(q.maxSpeedJump, 1e-9);
  EXPECT_LT(q.maxAngularSpeed, 1e-9);
}

// Keys -1, 1, 1, -1 reach 1.25 between the second and the third.
TEST(Quality, AFlightMayLeaveTheCube) {
  Flight flight = newFlight();
  Key key = flight.keys.front();
  flight.keys = KeyList();
  for (const double x : {-1.0, 1.0, 1.0, -1.0}) {
    key.position = {x, 0.1 * static_cast<double>(flight.keys.size()), 0.5};
    flight.keys.push_back(key);
  }
  const Evaluation evaluation(flight);
  std::int64_t outside = 0;
  for (std::int64_t n = 0; n < evaluation.frameCount(); ++n) {
    outside += evaluation.frame(n).camera.viewReferencePoint.x > 1.0 + 1e-9 ? 1 : 0;
  }
  EXPECT_GT(outside, 5);
  EXPECT_EQ(measureQuality(evaluation).framesOutsideCube, outside);
}

// The same bits, however a flight is cut: jumps between the parts count, and nothing twice.
TEST(Quality, PartsMakeUpTheWhole) {
  Flight flight = newFlight();
  Key key = flight.keys.front();
  flight.keys = KeyList();
  for (const double x : {-1.0, 1.0, 1.0, -1.0}) {
    key.position = {x, 0.1 * static_cast<double>(flight.keys.size()), 0.5};
    key.orientations.front().duration = 0.5 + x * x * static_cast<double>(flight.keys.size());
    key.orientations.front().roll = 40.0 * x;
    flight.keys.push_back(key);
  }
  const Evaluation evaluation(flight);
  const Quality whole = measureQuality(evaluation);
  EXPECT_GT(whole.maxSpeedJump, 0.1);
  EXPECT_GT(whole.framesOutsideCube, 5);
  const std::int64_t all = evaluation.frameCount();
  for (const std::int64_t part : {1, 2, 3, 7, 50, 1000}) {
    Quality parts;
    for (std::int64_t first = 0; first < all; first += part) {
      parts = together(parts, measureQuality(evaluation, first, std::min(all, first + part)));
    }
    EXPECT_EQ(parts, whole) << part;
  }
}

}  // namespace
}  // namespace vides
