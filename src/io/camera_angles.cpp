// SPDX-License-Identifier: MIT
// Taking the angles from the rotation's elements, and choosing among the equivalent ones.
#include "io/camera_angles.hpp"

#include <cmath>
#include <numbers>

namespace vides {
namespace {

constexpr double kPole = 1e-7;  // as where yaw and pitch are taken from an aim (2-flight-model)

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

// The angle plus or minus full turns that is nearest to `to`.
double nearest(double angle, double to) { return to + std::remainder(angle - to, 360.0); }

CameraAngles nearest(const CameraAngles& angles, const CameraAngles& to) {
  return {nearest(angles.rx, to.rx), nearest(angles.ry, to.ry), nearest(angles.rz, to.rz)};
}

double distance(const CameraAngles& a, const CameraAngles& b) {
  return std::abs(a.rx - b.rx) + std::abs(a.ry - b.ry) + std::abs(a.rz - b.rz);
}

// ry from what is left at a pole: the sum or the difference of ry and rz.
CameraAngles atPole(const Vec3& vpn, const Vec3& right, double rz) {
  // R = R_y(ry -+ rz) R_x(+-90): right = (cos, 0, -sin) of ry - rz (up) or ry + rz (down).
  const double rest = degrees(std::atan2(0.0 - right.z, right.x));
  return vpn.y > 0.0 ? CameraAngles{90.0, rest + rz, rz} : CameraAngles{-90.0, rest - rz, rz};
}

}  // namespace

CameraAngles AngleChain::next(const Camera& camera) {
  const Vec3& vpn = camera.viewPlaneNormal;
  const Vec3& up = camera.viewUpVector;
  const Vec3 right = glm::cross(vpn, up);
  const double across = std::hypot(vpn.x, vpn.z);
  CameraAngles angles;
  if (across < kPole) {
    angles = atPole(vpn, right, before_ ? before_->rz : 0.0);
    if (before_) angles = nearest(angles, *before_);
  } else {
    // 0 - x, so that +-0 both give half a turn to the left.
    angles = {degrees(std::atan2(vpn.y, across)), degrees(std::atan2(0.0 - vpn.x, 0.0 - vpn.z)),
              degrees(std::atan2(right.y, up.y))};
    if (before_) {
      const CameraAngles other =
          nearest({180.0 - angles.rx, angles.ry + 180.0, angles.rz + 180.0}, *before_);
      angles = nearest(angles, *before_);
      if (distance(other, *before_) < distance(angles, *before_)) angles = other;
    }
  }
  before_ = angles;
  return angles;
}

}  // namespace vides
