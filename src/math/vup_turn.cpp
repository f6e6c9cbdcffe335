// SPDX-License-Identifier: MIT
// The bisection on the projected circle of the VUP's tip.
#include "math/vup_turn.hpp"

#include <cmath>
#include <numbers>

#include "math/plane_drag.hpp"
#include "math/quaternion.hpp"

namespace vides {
namespace {

constexpr int kHalvings = 50;

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

tl::expected<double, TurnRefusal> rollTowards(const ViewProjection& view, const Vec3& vrp,
                                              const Vec3& vpn, const Vec2& pointer) {
  const auto center = view.project(vrp);
  if (!center) return tl::unexpected(TurnRefusal::NotInFront);
  // The tip is seen in the direction a cos(roll) + b sin(roll), in perspective too, whatever the
  // length of the arrow.
  const glm::dmat3x2 jacobian = view.jacobian(vrp);
  const Vec2 a = jacobian * viewUpVector(vpn, 0.0);
  const Vec2 b = jacobian * viewUpVector(vpn, 0.5 * std::numbers::pi);
  if (smallestSingularValue(a, b) < kEdgeOnPixelsPerUnit) {
    return tl::unexpected(TurnRefusal::CircleEdgeOn);
  }
  const Vec2 wanted = pointer - *center;
  if (wanted == Vec2{0.0}) return tl::unexpected(TurnRefusal::PointerAtCenter);

  // Seen from behind, the roll runs the other way round.
  const double sense = cross(a, b) < 0.0 ? -1.0 : 1.0;
  const auto liesBeyond = [&](double roll) {
    return sense * cross(std::cos(roll) * a + std::sin(roll) * b, wanted) >= 0.0;
  };
  // Which side of the line through the positions of 0 and 180 degrees, then halve.
  double lo = liesBeyond(0.0) ? 0.0 : -std::numbers::pi;
  double hi = lo + std::numbers::pi;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (lo + hi);
    (liesBeyond(middle) ? lo : hi) = middle;
  }
  return 0.5 * (lo + hi);
}

}  // namespace vides
