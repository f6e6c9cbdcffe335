// SPDX-License-Identifier: MIT
// The dragged point lies under the pointer, or the drag is refused for the reason that holds.
#include "math/plane_drag.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "math/random.hpp"
#include "math/random_view.hpp"

namespace vides {
namespace {

using test::Random;
using test::randomView;

constexpr Axis kAxes[] = {Axis::X, Axis::Y, Axis::Z};

// The smallest singular value by a scan over directions: the shortest image of a unit vector.
double shortestImage(const Vec2& a, const Vec2& b) {
  double shortest = 1e300, best = 0.0, width = 1.6;
  for (int round = 0; round < 8; ++round) {
    const double center = best;
    for (int i = -40; i <= 40; ++i) {
      const double angle = center + width * i / 40;
      const double length = glm::length(std::cos(angle) * a + std::sin(angle) * b);
      if (length < shortest) {
        shortest = length;
        best = angle;
      }
    }
    width /= 20;
  }
  return shortest;
}

// Pixels per unit along an axis, by differences.
Vec2 slope(const ViewProjection& view, const Vec3& point, int axis) {
  Vec3 step{0.0};
  step[axis] = 1e-5 * std::min(1.0, view.weight(point));
  return (*view.project(point + step) - *view.project(point - step)) / (2 * step[axis]);
}

struct Case {
  Grab grab;
  Vec2 pointer;
};
Case anyCase(Random& random) {
  Grab grab;
  grab.view = randomView(random);
  grab.point = random.inCube();
  const Vec2 at = grab.view.project(grab.point).value_or(Vec2{0.0});
  grab.pointer = at + Vec2{random.between(-10, 10), random.between(-10, 10)};
  return {grab, grab.pointer + Vec2{random.between(-400, 400), random.between(-400, 400)}};
}

TEST(PlaneDrag, ThePointFollowsThePointer) {
  Random random(71);
  int moved = 0, edgeOn = 0, behind = 0, horizon = 0;
  for (int i = 0; i < 20000; ++i) {
    const Case c = anyCase(random);
    for (const Axis axis : kAxes) {
      const int k = static_cast<int>(axis);
      const auto result = dragInPlane(c.grab, axis, c.pointer);
      if (!result && result.error() == DragRefusal::NotInFront) {
        ++behind;
        ASSERT_FALSE(c.grab.view.project(c.grab.point).has_value());
        continue;
      }
      const Vec2 start = *c.grab.view.project(c.grab.point);
      const double sigma = shortestImage(slope(c.grab.view, c.grab.point, (k + 1) % 3),
                                         slope(c.grab.view, c.grab.point, (k + 2) % 3));
      if (result) {
        ++moved;
        ASSERT_GT(sigma, kEdgeOnPixelsPerUnit * (1 - 1e-4));
        ASSERT_EQ((*result)[k], c.grab.point[k]);
        const auto now = c.grab.view.project(*result);
        ASSERT_TRUE(now.has_value());
        ASSERT_LT(glm::distance(*now - start, c.pointer - c.grab.pointer), 1e-6);
      } else if (result.error() == DragRefusal::BeyondHorizon) {
        ++horizon;
        ASSERT_TRUE(c.grab.view.perspective());
        // The ray runs away from the plane.
        const Ray ray = c.grab.view.ray(start + c.pointer - c.grab.pointer);
        ASSERT_LE((c.grab.point[k] - ray.origin[k]) * ray.direction[k], 0.0);
      } else {
        ++edgeOn;
        const DragRefusal expected[] = {DragRefusal::PlaneXEdgeOn, DragRefusal::PlaneYEdgeOn,
                                        DragRefusal::PlaneZEdgeOn};
        ASSERT_EQ(result.error(), expected[k]);
        ASSERT_LT(sigma, kEdgeOnPixelsPerUnit * (1 + 1e-4));
      }
    }
  }
  // Each way out was taken, and most drags move.
  EXPECT_GT(moved, 40000);
  EXPECT_GT(edgeOn, 100);
  EXPECT_GT(behind, 100);
  EXPECT_GT(horizon, 100);
}

TEST(PlaneDrag, AtThePressNothingMoves) {
  Random random(72);
  for (int i = 0; i < 10000; ++i) {
    const Case c = anyCase(random);
    for (const Axis axis : kAxes) {
      const auto inPlane = dragInPlane(c.grab, axis, c.grab.pointer);
      if (inPlane) {
        ASSERT_LT(glm::distance(*inPlane, c.grab.point), 1e-10);
      }
      const auto along = dragAlongAxis(c.grab, axis, c.grab.pointer);
      if (along) {
        ASSERT_EQ(*along, c.grab.point);
      }
    }
  }
}

TEST(PlaneDrag, ByHandFromTheFront) {
  // 600 pixels show 2 sqrt 3 units; from the front x runs right and y up.
  const double unit = 600 / (2 * std::sqrt(3.0));
  Grab grab{viewProjection(EditorView{0, 0}, {0, 0, 600, 600}), {0.1, 0.2, 0.3}, {0, 0}};
  const auto moved = dragInPlane(grab, Axis::Z, {0.5 * unit, -0.25 * unit});
  ASSERT_TRUE(moved.has_value());
  EXPECT_LT(glm::distance(*moved, Vec3(0.6, 0.45, 0.3)), 1e-14);
  EXPECT_EQ(dragInPlane(grab, Axis::X, {10, 10}).error(), DragRefusal::PlaneXEdgeOn);
  EXPECT_EQ(dragInPlane(grab, Axis::Y, {10, 10}).error(), DragRefusal::PlaneYEdgeOn);
  EXPECT_LT(glm::distance(*dragAlongAxis(grab, Axis::X, {0.5 * unit, 77}), Vec3(0.6, 0.2, 0.3)),
            1e-14);
  EXPECT_LT(glm::distance(*dragAlongAxis(grab, Axis::Y, {77, 0.5 * unit}), Vec3(0.1, -0.3, 0.3)),
            1e-14);
  EXPECT_EQ(dragAlongAxis(grab, Axis::Z, {10, 10}).error(), DragRefusal::AxisZEndOn);
  grab.view = viewProjection(EditorView{90, 0}, {0, 0, 600, 600});
  EXPECT_EQ(dragInPlane(grab, Axis::Z, {10, 10}).error(), DragRefusal::PlaneZEdgeOn);
  EXPECT_EQ(dragAlongAxis(grab, Axis::X, {10, 10}).error(), DragRefusal::AxisXEndOn);
  grab.view = viewProjection(EditorView{0, 90}, {0, 0, 600, 600});
  EXPECT_EQ(dragAlongAxis(grab, Axis::Y, {10, 10}).error(), DragRefusal::AxisYEndOn);
}

TEST(PlaneDrag, TheLimitIsTenPixelsPerUnit) {
  // From the front, tilted by e: the plane y = const shows z foreshortened by sin e.
  const double unit = 600 / (2 * std::sqrt(3.0));
  const double limit = std::asin(10 / unit) * 180 / std::acos(-1.0);
  for (const auto& [tilt, moves] : {std::pair{limit * 0.999, false}, {limit * 1.001, true}}) {
    const Grab grab{viewProjection(EditorView{0, tilt}, {0, 0, 600, 600}), Vec3{0.0}, {300, 300}};
    EXPECT_EQ(dragInPlane(grab, Axis::Y, {310, 310}).has_value(), moves);
  }
}

TEST(PlaneDrag, AnAxisComesAsCloseAsItCan) {
  Random random(73);
  int moved = 0, endOn = 0, horizon = 0;
  for (int i = 0; i < 20000; ++i) {
    const Case c = anyCase(random);
    const Axis axis = kAxes[i % 3];
    const int k = static_cast<int>(axis);
    const auto result = dragAlongAxis(c.grab, axis, c.pointer);
    const auto start = c.grab.view.project(c.grab.point);
    if (!result) {
      if (result.error() == DragRefusal::NotInFront) {
        ASSERT_FALSE(start.has_value());
      } else if (result.error() == DragRefusal::BeyondHorizon) {
        ++horizon;
        ASSERT_TRUE(c.grab.view.perspective());
      } else {
        ++endOn;
        ASSERT_LT(glm::length(slope(c.grab.view, c.grab.point, k)), 10.001);
      }
      continue;
    }
    ++moved;
    const Vec2 wanted = *start + c.pointer - c.grab.pointer;
    const auto off = [&](double along) {
      Vec3 p = c.grab.point;
      p[k] = along;
      const auto at = c.grab.view.project(p);
      return at ? glm::distance(*at, wanted) : 1e300;
    };
    for (int j = 0; j < 3; ++j) {
      if (j != k) {
        ASSERT_EQ((*result)[j], c.grab.point[j]);
      }
    }
    // No place along the axis is closer: neither near by nor far off.
    const double best = off((*result)[k]);
    const double range = std::abs((*result)[k] - c.grab.point[k]) + 1.0;
    for (const double step : {1e-4, 1e-2, 0.3, 1.0, 10.0}) {
      ASSERT_LE(best, off((*result)[k] + step * range) + 1e-6);
      ASSERT_LE(best, off((*result)[k] - step * range) + 1e-6);
    }
  }
  EXPECT_GT(moved, 12000);
  EXPECT_GT(endOn, 5);
  EXPECT_GT(horizon, 10);
}

TEST(PlaneDrag, SmallestSingularValue) {
  EXPECT_DOUBLE_EQ(smallestSingularValue({3, 0}, {0, 4}), 3.0);
  EXPECT_DOUBLE_EQ(smallestSingularValue({1, 1}, {2, 2}), 0.0);
  EXPECT_DOUBLE_EQ(smallestSingularValue({0, 0}, {0, 0}), 0.0);
  Random random(74);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 a{random.between(-9, 9), random.between(-9, 9)};
    const Vec2 b{random.between(-9, 9), random.between(-9, 9)};
    ASSERT_NEAR(smallestSingularValue(a, b), shortestImage(a, b), 1e-8);
  }
}

}  // namespace
}  // namespace vides
