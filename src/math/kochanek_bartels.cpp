// SPDX-License-Identifier: MIT
// Kochanek-Bartels tangents, and the guarded quadratic rule where a curve ends.
#include "math/kochanek_bartels.hpp"

#include <algorithm>

namespace vides {
namespace {

// The tangent at a free end: that of the parabola that leaves the chord as the far tangent demands,
// the far tangent counting no longer than twice the chord, so that the curve never starts
// backwards.
Vec3 endTangent(const Vec3& chord, const Vec3& far, double tension) {
  const double limit = 2.0 * glm::length(chord), length = glm::length(far);
  const double s = length > limit ? limit / length : 1.0;
  return (1.0 - tension) * (2.0 * chord - s * far);
}

const Vec3* apart(const Vec3* neighbour, const Vec3& point) {
  return neighbour && glm::distance(*neighbour, point) >= kCoincident ? neighbour : nullptr;
}

}  // namespace

Tangents kochanekBartelsTangents(const Vec3& before, const Vec3& point, const Vec3& after,
                                 const Shape& shape) {
  const Vec3 in = point - before, out = after - point;
  const double half = 0.5 * (1.0 - shape.tension);
  const double c = shape.continuity, b = shape.bias;
  return {half * ((1.0 - c) * (1.0 + b) * in + (1.0 + c) * (1.0 - b) * out),
          half * ((1.0 + c) * (1.0 + b) * in + (1.0 - c) * (1.0 - b) * out)};
}

CubicSegment kochanekBartelsSegment(const Vec3* before, const Vec3& p0, const Shape& shape0,
                                    const Vec3& p1, const Shape& shape1, const Vec3* after) {
  const Vec3 chord = p1 - p0;
  if (glm::distance(p0, p1) < kCoincident) return CubicSegment::hermite(p0, chord, p1, chord);
  before = apart(before, p0);
  after = apart(after, p1);

  Vec3 r0 = (1.0 - shape0.tension) * chord, r1 = (1.0 - shape1.tension) * chord;
  if (before) r0 = kochanekBartelsTangents(*before, p0, p1, shape0).outgoing;
  if (after) r1 = kochanekBartelsTangents(p0, p1, *after, shape1).incoming;
  if (after && !before) r0 = endTangent(chord, r1, shape0.tension);
  if (before && !after) r1 = endTangent(chord, r0, shape1.tension);
  return CubicSegment::hermite(p0, r0, p1, r1);
}

}  // namespace vides
