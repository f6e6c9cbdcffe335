// SPDX-License-Identifier: MIT
// Flying the camera: turn, move, roll, zoom.
#include "edit/free_camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/lens.hpp"
#include "math/quaternion.hpp"

namespace vides {
namespace {

// v turned about a unit axis (Rodrigues).
Vec3 turned(const Vec3& v, const Vec3& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return c * v + s * glm::cross(axis, v) + (1.0 - c) * glm::dot(axis, v) * axis;
}

constexpr Vec3 kUp{0.0, 1.0, 0.0};

}  // namespace

Camera normalized(Camera camera) {
  camera.viewPlaneNormal = glm::normalize(camera.viewPlaneNormal);
  const Vec3& n = camera.viewPlaneNormal;
  const Vec3 up = camera.viewUpVector - glm::dot(camera.viewUpVector, n) * n;
  camera.viewUpVector =
      glm::length(up) > 1e-12 ? glm::normalize(up) : viewUpVector(camera.viewPlaneNormal, 0.0);
  return camera;
}

Camera turnedCamera(const Camera& camera, double yaw, double pitch) {
  Camera result = camera;
  const Vec3& n = camera.viewPlaneNormal;
  const Vec3 across = glm::cross(n, kUp);
  const double level = glm::length(across);
  // Straight up or down the camera's own right is all there is to pitch about.
  const Vec3 right =
      level > 1e-9 ? across / level : glm::cross(camera.viewPlaneNormal, camera.viewUpVector);
  const double elevation = std::atan2(n.y, level);
  const double half = 0.5 * std::numbers::pi;
  const double down = std::clamp(pitch, elevation - half, elevation + half);
  for (Vec3* v : {&result.viewPlaneNormal, &result.viewUpVector}) {
    *v = turned(turned(*v, right, -down), kUp, yaw);
  }
  return normalized(result);
}

Camera movedCamera(const Camera& camera, double right, double up, double ahead) {
  Camera result = camera;
  const Vec3 across = glm::cross(camera.viewPlaneNormal, camera.viewUpVector);
  result.viewReferencePoint +=
      right * across + up * camera.viewUpVector + ahead * camera.viewPlaneNormal;
  return result;
}

Camera rolledCamera(const Camera& camera, double roll) {
  Camera result = camera;
  result.viewUpVector = turned(camera.viewUpVector, camera.viewPlaneNormal, roll);
  return normalized(result);
}

Camera zoomedCamera(const Camera& camera, double zoomBy) {
  Camera result = camera;
  result.zoom = std::clamp(camera.zoom + zoomBy, kMinZoom, kMaxZoom);
  return result;
}

double rollOf(const Camera& camera) {
  const double roll = yawPitchRollOf(camera.viewPlaneNormal, camera.viewUpVector).roll;
  return roll * 180.0 / std::numbers::pi;
}

}  // namespace vides
