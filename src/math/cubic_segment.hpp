// SPDX-License-Identifier: MIT
// One cubic piece of a curve, Q(u) = a u^3 + b u^2 + c u + d with u in [0, 1].
#pragma once

#include "math/vector.hpp"

namespace vides {

struct CubicSegment {
  Vec3 a{0.0}, b{0.0}, c{0.0}, d{0.0};

  // The piece from p0 to p1 with the tangents r0 at u = 0 and r1 at u = 1 (Hermite form).
  static CubicSegment hermite(const Vec3& p0, const Vec3& r0, const Vec3& p1, const Vec3& r1);

  Vec3 point(double u) const { return ((a * u + b) * u + c) * u + d; }
  Vec3 derivative(double u) const { return (3.0 * a * u + 2.0 * b) * u + c; }
  Vec3 secondDerivative(double u) const { return 6.0 * a * u + 2.0 * b; }
  Vec3 thirdDerivative() const { return 6.0 * a; }
  bool operator==(const CubicSegment&) const = default;
};

}  // namespace vides
