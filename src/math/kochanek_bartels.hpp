// SPDX-License-Identifier: MIT
// Kochanek-Bartels curves (paper 3.6.2): tangents from neighbouring points and shapes.
//
// Bias > 0 overshoots. Ends (which the paper leaves free) use the guarded quadratic rule of
// 2-flight-model: with D = P1 - P0 and R the incoming tangent at P1,
// R0 = (1 - t0)(2D - sR), s = min(1, 2|D|/|R|), mirrored at the last point; continuity and bias are
// ignored at ends; two points give a straight line.
#pragma once

#include "math/cubic_segment.hpp"

namespace vides {

// Tension, continuity and bias at a key, each in [-1, 1].
struct Shape {
  double tension = 0.0;
  double continuity = 0.0;
  double bias = 0.0;
  bool operator==(const Shape&) const = default;
};

// Neighbours closer than this count as one place: the curve ends on both sides there.
inline constexpr double kCoincident = 1e-9;

struct Tangents {
  Vec3 incoming{0.0};  // R2: at the end of the piece that arrives
  Vec3 outgoing{0.0};  // R1: at the start of the piece that leaves
};

// The tangents at an inner point from the chords d- = P - before and d+ = after - P.
Tangents kochanekBartelsTangents(const Vec3& before, const Vec3& point, const Vec3& after,
                                 const Shape& shape);

// The piece from p0 to p1. `before` and `after` are the points beyond, null where the curve ends at
// p0 or at p1. A neighbour closer than kCoincident counts as null. If p0 and p1 themselves are that
// close, the piece is the straight line between them.
CubicSegment kochanekBartelsSegment(const Vec3* before, const Vec3& p0, const Shape& shape0,
                                    const Vec3& p1, const Shape& shape1, const Vec3* after);

}  // namespace vides
