// SPDX-License-Identifier: MIT
// The VUP points towards the pointer: against the closed form, and by projecting its tip.
#include "math/vup_turn.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "math/plane_drag.hpp"
#include "math/quaternion.hpp"
#include "math/random.hpp"
#include "math/random_view.hpp"

namespace vides {
namespace {

using test::Random;
using test::randomView;

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180.0;

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

Vec3 anyVpn(Random& random, int i) {
  if (i % 10 != 0) return random.direction();
  return Vec3{0, random.coin() ? 1.0 : -1.0, 0};
}

TEST(VupTurn, AgreesWithTheClosedForm) {
  Random random(81);
  int turned = 0, edgeOn = 0, behind = 0;
  for (int i = 0; i < 20000; ++i) {
    const ViewProjection view = randomView(random);
    const Vec3 vrp = random.inCube(), vpn = anyVpn(random, i);
    const auto center = view.project(vrp);
    const Vec2 wanted{random.between(-300, 300), random.between(-300, 300)};
    const auto roll = rollTowards(view, vrp, vpn, center.value_or(Vec2{0.0}) + wanted);
    if (!center) {
      ++behind;
      ASSERT_EQ(roll.error(), TurnRefusal::NotInFront);
      continue;
    }
    // The images of the two half axes, by differences.
    const double h = 1e-5 * std::min(1.0, view.weight(vrp));
    const auto image = [&](const Vec3& v) {
      return (*view.project(vrp + h * v) - *view.project(vrp - h * v)) / (2 * h);
    };
    const Vec2 a = image(viewUpVector(vpn, 0)), b = image(viewUpVector(vpn, kPi / 2));
    const double sigma = smallestSingularValue(a, b);
    if (!roll) {
      ++edgeOn;
      ASSERT_EQ(roll.error(), TurnRefusal::CircleEdgeOn);
      ASSERT_LT(sigma, kEdgeOnPixelsPerUnit * 1.0001);
      continue;
    }
    ++turned;
    ASSERT_GT(sigma, kEdgeOnPixelsPerUnit * 0.9999);
    const double sign = cross(a, b) < 0 ? -1 : 1;
    const double closed = std::atan2(sign * cross(a, wanted), sign * cross(wanted, b));
    ASSERT_LT(std::abs(std::remainder(*roll - closed, 2 * kPi)), 0.01 * kDegree);
  }
  EXPECT_GT(turned, 15000);
  EXPECT_GT(edgeOn, 100);
  EXPECT_GT(behind, 50);
}

TEST(VupTurn, TheTipIsSeenTowardsThePointer) {
  Random random(82);
  int turned = 0;
  for (int i = 0; i < 20000; ++i) {
    const ViewProjection view = randomView(random);
    const Vec3 vrp = random.inCube(), vpn = anyVpn(random, i);
    const auto center = view.project(vrp);
    if (!center) continue;
    const Vec2 wanted{random.between(-300, 300), random.between(-300, 300)};
    const auto roll = rollTowards(view, vrp, vpn, *center + wanted);
    if (!roll) continue;
    // A long arrow too, as long as it stays in front.
    const auto tip = view.project(vrp + random.between(0.01, 0.5) * viewUpVector(vpn, *roll));
    if (!tip) continue;
    ++turned;
    const Vec2 seen = *tip - *center;
    ASSERT_LT(std::abs(std::atan2(cross(seen, wanted), glm::dot(seen, wanted))), 1e-8);
  }
  EXPECT_GT(turned, 14000);
}

TEST(VupTurn, ByHandFromTheFront) {
  // The camera looks towards the viewer (+z), so its VUP turns towards -x, the viewer's left.
  const ViewProjection view = viewProjection(EditorView{0, 0}, {0, 0, 600, 600});
  const Vec3 vrp{0.0}, vpn{0, 0, 1};
  EXPECT_NEAR(*rollTowards(view, vrp, vpn, {300, 100}), 0, 1e-14);
  EXPECT_NEAR(*rollTowards(view, vrp, vpn, {100, 300}), 90 * kDegree, 1e-14);
  EXPECT_NEAR(*rollTowards(view, vrp, vpn, {500, 300}), -90 * kDegree, 1e-14);
  EXPECT_NEAR(std::abs(*rollTowards(view, vrp, vpn, {300, 500})), 180 * kDegree, 1e-14);
  EXPECT_NEAR(*rollTowards(view, vrp, vpn, {200, 200}), 45 * kDegree, 1e-14);
  // Away from the viewer: the other way round.
  EXPECT_NEAR(*rollTowards(view, vrp, {0, 0, -1}, {100, 300}), -90 * kDegree, 1e-14);
}

TEST(VupTurn, RefusesWithoutADirection) {
  const ViewProjection view = viewProjection(EditorView{0, 0}, {0, 0, 600, 600});
  EXPECT_EQ(rollTowards(view, Vec3{0.0}, {0, 0, 1}, *view.project(Vec3{0.0})).error(),
            TurnRefusal::PointerAtCenter);
  EXPECT_EQ(rollTowards(view, Vec3{0.0}, {1, 0, 0}, {100, 100}).error(), TurnRefusal::CircleEdgeOn);
}

}  // namespace
}  // namespace vides
