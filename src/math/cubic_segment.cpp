// SPDX-License-Identifier: MIT
// Builds one cubic piece from its end points and tangents.
#include "math/cubic_segment.hpp"

namespace vides {

CubicSegment CubicSegment::hermite(const Vec3& p0, const Vec3& r0, const Vec3& p1, const Vec3& r1) {
  const Vec3 chord = p1 - p0;
  return {(r0 - chord) + (r1 - chord), 3.0 * chord - 2.0 * r0 - r1, r0, p0};
}

}  // namespace vides
