// SPDX-License-Identifier: MIT
// What all orientation methods share.
#include "evaluate/orientation_path.hpp"

#include <cmath>

namespace vides {
namespace {

// Ends closer than this do not turn.
constexpr double kStill = 1e-12;

double distance(const Quaternion& a, const Quaternion& b) {
  const double w = a.w - b.w, x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return std::sqrt(w * w + x * x + y * y + z * z);
}

}  // namespace

ViewDirection viewDirection(const Quaternion& q) { return {viewPlaneNormal(q), viewUpVector(q)}; }

bool PathSection::still() const { return hold || distance(start, end) < kStill; }

Vec3 PathSection::turnRate() const { return log(end * glm::conjugate(start)) / work; }

}  // namespace vides
