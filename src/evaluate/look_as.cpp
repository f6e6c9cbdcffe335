// SPDX-License-Identifier: MIT
// From a camera to the orientation that sees what it sees.
#include "evaluate/look_as.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/quaternion.hpp"

namespace vides {
namespace {

// What rounding made of a 0.
double withoutNoise(double value) { return std::abs(value) < 1e-12 ? 0.0 : value; }

// In nearer aims a coordinate as small as this would count.
constexpr double kNoNoiseWithin = 0.01;

}  // namespace

double rollOf(const Camera& camera, const Key& key, const Orientation& orientation) {
  // The roll belongs to the VPN that the rounded aim gives: near the poles they mustn't differ.
  const Vec3 vpn = glm::normalize(aimOffset(key, orientation));
  const double roll = yawPitchRollOf(vpn, camera.viewUpVector).roll;
  return withoutNoise(roll * 180.0 / std::numbers::pi);
}

void lookAs(const Camera& camera, const Key& key, double distance, Orientation& orientation) {
  setAimPoint(key, orientation, key.position + distance * camera.viewPlaneNormal);
  if (orientation.aimMode == AimMode::kRelative) {
    orientation.aim = distance * camera.viewPlaneNormal;
  }
  if (distance >= kNoNoiseWithin) {
    for (int i = 0; i < 3; ++i) orientation.aim[i] = withoutNoise(orientation.aim[i]);
  }
  orientation.roll = rollOf(camera, key, orientation);
  orientation.zoom = camera.zoom;
}

}  // namespace vides
