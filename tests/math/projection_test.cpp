// SPDX-License-Identifier: MIT
// PHIGS view orientation and mapping against look-at, orthographic and frustum matrices formed
// independently, and oblique projections worked by hand.
#include "math/projection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "math/quaternion.hpp"
#include "math/random.hpp"

namespace vides {
namespace {

using test::Random;

constexpr double kDegree = std::numbers::pi / 180.0;

double difference(const glm::dmat4& a, const glm::dmat4& b) {
  double largest = 0.0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) largest = std::max(largest, std::abs(a[i][j] - b[i][j]));
  }
  return largest;
}

Vec3 divided(const glm::dmat4& m, const Vec3& p) {
  const glm::dvec4 c = m * glm::dvec4(p, 1.0);
  return Vec3{c} / c.w;
}

ViewMapping randomMapping(Random& random, ProjectionType type) {
  ViewMapping m;
  m.type = type;
  m.window.uMin = random.between(-3, 1);
  m.window.uMax = m.window.uMin + random.between(0.1, 4);
  m.window.vMin = random.between(-3, 1);
  m.window.vMax = m.window.vMin + random.between(0.1, 4);
  m.viewPlaneDistance = random.between(-2, 2);
  m.backPlaneDistance = random.between(-5, 1);
  m.frontPlaneDistance = m.backPlaneDistance + random.between(0.1, 4);
  const double beyond = std::max(m.viewPlaneDistance, m.frontPlaneDistance);
  m.projectionReferencePoint = {random.between(-2, 2), random.between(-2, 2),
                                beyond + random.between(0.1, 5)};
  return m;
}

TEST(ViewOrientation, IsLookAt) {
  Random random(51);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 vrp = random.inCube(), vpn = random.direction(), vup = random.direction();
    if (glm::length(glm::cross(vpn, vup)) < 1e-3) continue;
    ASSERT_LT(difference(viewOrientation(vrp, random.between(0.1, 9) * vpn, vup),
                         glm::lookAt(vrp, vrp + vpn, vup)),
              1e-12);
  }
}

TEST(ViewOrientation, AgreesWithTheCameraAxes) {
  // right = VPN x VUP, up = VUP, back = -VPN.
  Random random(52);
  for (int i = 0; i < 10000; ++i) {
    const Quaternion q = random.orientation();
    const Vec3 vpn = viewPlaneNormal(q), vup = viewUpVector(q);
    const ViewAxes axes = viewAxes(vpn, vup);
    ASSERT_LT(glm::distance(axes.u, glm::cross(vpn, vup)), 3e-15);
    ASSERT_LT(glm::distance(axes.v, vup), 3e-15);
    ASSERT_LT(glm::distance(axes.n, -vpn), 3e-15);
  }
  const ViewAxes rest = viewAxes({0, 0, 1}, {0, 1, 0});
  EXPECT_EQ(rest.u, Vec3(-1, 0, 0));
  EXPECT_EQ(rest.v, Vec3(0, 1, 0));
  EXPECT_EQ(rest.n, Vec3(0, 0, -1));
}

TEST(ViewOrientation, NoDirectionIsSpecial) {
  // Along each axis, by hand: right = VPN x VUP.
  const ViewAxes x = viewAxes({1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(x.u, Vec3(0, 0, 1));
  EXPECT_EQ(x.v, Vec3(0, 1, 0));
  const ViewAxes y = viewAxes({0, 1, 0}, {0, 0, -1});
  EXPECT_EQ(y.u, Vec3(-1, 0, 0));
  EXPECT_EQ(y.v, Vec3(0, 0, -1));
  // A VUP along the VPN: that of roll 0 takes its place, from both poles.
  for (const Vec3& vpn : {Vec3{0, 1, 0}, Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0.6, 0, -0.8}}) {
    for (const double scale : {-2.0, 0.0, 1e-30, 1.0}) {
      const ViewAxes axes = viewAxes(vpn, scale * vpn);
      EXPECT_LT(glm::distance(axes.v, viewUpVector(vpn, 0.0)), 1e-15);
      EXPECT_LT(glm::distance(glm::cross(axes.u, axes.v), axes.n), 1e-15);
    }
  }
  // No direction at all is the rest direction.
  EXPECT_EQ(viewAxes(Vec3{0.0}, {0, 1, 0}).n, Vec3(0, 0, -1));
}

TEST(ViewMapping, IsOrthoWhereTheRaysRunAlongN) {
  Random random(53);
  for (int i = 0; i < 10000; ++i) {
    ViewMapping m = randomMapping(random, ProjectionType::Parallel);
    m.projectionReferencePoint.x = m.window.center().x;
    m.projectionReferencePoint.y = m.window.center().y;
    const glm::dmat4 expected =
        glm::ortho(m.window.uMin, m.window.uMax, m.window.vMin, m.window.vMax,
                   -m.frontPlaneDistance, -m.backPlaneDistance);
    ASSERT_LT(difference(*viewMapping(m), expected), 1e-10);
  }
}

TEST(ViewMapping, IsFrustumWhereTheReferencePointIsTheOrigin) {
  Random random(54);
  for (int i = 0; i < 10000; ++i) {
    ViewMapping m = randomMapping(random, ProjectionType::Perspective);
    m.projectionReferencePoint = {0, 0, 0};
    const double near = random.between(0.01, 2), far = near + random.between(0.1, 9);
    m.viewPlaneDistance = -near;
    m.frontPlaneDistance = -near;
    m.backPlaneDistance = -far;
    const glm::dmat4 expected =
        glm::frustum(m.window.uMin, m.window.uMax, m.window.vMin, m.window.vMax, near, far);
    ASSERT_LT(difference(*viewMapping(m), expected), 1e-10);
    // A view plane twice as far needs a window twice as large, and front and back stay.
    ViewMapping twice = m;
    twice.viewPlaneDistance *= 2;
    twice.window = {2 * m.window.uMin, 2 * m.window.uMax, 2 * m.window.vMin, 2 * m.window.vMax};
    const Vec3 p = random.inCube() - Vec3{0, 0, 1.5};
    ASSERT_LT(glm::distance(divided(*viewMapping(m), p), divided(*viewMapping(twice), p)), 1e-9);
  }
}

TEST(ViewMapping, IsWhereTheRayMeetsTheViewPlane) {
  // Geometry in place of matrices: oblique and off-center ones too.
  Random random(55);
  for (int i = 0; i < 20000; ++i) {
    const bool parallel = random.coin();
    const ViewMapping m =
        randomMapping(random, parallel ? ProjectionType::Parallel : ProjectionType::Perspective);
    const Vec3& prp = m.projectionReferencePoint;
    const Vec3 center{m.window.center(), m.viewPlaneDistance};
    Vec3 p{random.between(-3, 3), random.between(-3, 3), 0.0};
    p.z = prp.z - random.between(0.05, 8);
    const Vec3 along = parallel ? center - prp : p - prp;
    const Vec3 hit = p + (m.viewPlaneDistance - p.z) / along.z * along;
    const Vec2 half{0.5 * (m.window.uMax - m.window.uMin), 0.5 * (m.window.vMax - m.window.vMin)};
    const Vec2 expected = (Vec2{hit} - Vec2{center}) / half;
    const Vec3 actual = divided(*viewMapping(m), p);
    ASSERT_LT(glm::distance(Vec2{actual}, expected), 1e-10 * (1 + glm::length(expected)));
    // Front and back plane, and the order of depths between.
    const glm::dmat4 matrix = *viewMapping(m);
    ASSERT_NEAR(divided(matrix, {p.x, p.y, m.frontPlaneDistance}).z, -1.0, 1e-10);
    ASSERT_NEAR(divided(matrix, {p.x, p.y, m.backPlaneDistance}).z, 1.0, 1e-10);
    const double middle = 0.5 * (m.frontPlaneDistance + m.backPlaneDistance);
    ASSERT_LT(std::abs(divided(matrix, {p.x, p.y, middle}).z), 1.0);
  }
}

// The image on the view plane n = 0 of an oblique projection in which a unit along n becomes
// `ratio` long, at `angle` to u.
Vec2 oblique(double ratio, double angle, const Vec3& p) {
  ViewMapping m;
  m.window = {-1, 1, -1, 1};
  m.projectionReferencePoint = {-ratio * std::cos(angle), -ratio * std::sin(angle), 1.0};
  return Vec2{divided(*viewMapping(m), p)};
}

TEST(ViewMapping, CavalierKeepsLengthsAlongN) {
  // Rays at 45 degrees to the view plane, 30 degrees drawn: (0, 0, 1) goes to (cos 30, sin 30).
  const Vec2 tip = oblique(1.0, 30 * kDegree, {0, 0, 1});
  EXPECT_NEAR(tip.x, 0.866025403784439, 1e-15);
  EXPECT_NEAR(tip.y, 0.5, 1e-15);
  EXPECT_NEAR(glm::length(tip), 1.0, 1e-15);
  // A corner of the cube: (1, 1, -1) lies behind, so it moves to the lower left.
  const Vec2 corner = oblique(1.0, 45 * kDegree, {1, 1, -1});
  EXPECT_NEAR(corner.x, 1 - std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(corner.y, 1 - std::sqrt(0.5), 1e-15);
  // What lies in the view plane stays.
  EXPECT_NEAR(oblique(1.0, 1.0, {0.3, -0.4, 0}).x, 0.3, 1e-15);
  EXPECT_NEAR(oblique(1.0, 1.0, {0.3, -0.4, 0}).y, -0.4, 1e-15);
}

TEST(ViewMapping, CabinetHalvesLengthsAlongN) {
  // Rays at atan 2 = 63.4349 degrees to the view plane: the foreshortening is 1/tan = 1/2.
  EXPECT_NEAR(1 / std::tan(63.434948822922 * kDegree), 0.5, 1e-13);
  const Vec2 tip = oblique(1 / std::tan(63.434948822922 * kDegree), 30 * kDegree, {0, 0, 1});
  EXPECT_NEAR(tip.x, 0.433012701892219, 1e-13);
  EXPECT_NEAR(tip.y, 0.25, 1e-13);
}

TEST(ViewMapping, PerspectiveByHand) {
  // By hand: eye at n = 2, view plane n = 0. (1, 1, -2) is twice as far as its image (1/2, 1/2).
  ViewMapping m;
  m.type = ProjectionType::Perspective;
  m.projectionReferencePoint = {0, 0, 2};
  m.backPlaneDistance = -4;
  const Vec3 image = divided(*viewMapping(m), {1, 1, -2});
  EXPECT_NEAR(image.x, 0.5, 1e-15);
  EXPECT_NEAR(image.y, 0.5, 1e-15);
  // An eye off the middle, (1, 0, 2): the line from it to (1, 1, -2) meets n = 0 at (1, 1/2).
  m.projectionReferencePoint = {1, 0, 2};
  EXPECT_NEAR(divided(*viewMapping(m), {1, 1, -2}).x, 1.0, 1e-15);
  EXPECT_NEAR(divided(*viewMapping(m), {1, 1, -2}).y, 0.5, 1e-15);
}

TEST(ViewMapping, RefusesWhatHasNoImage) {
  const auto error = [](auto change) {
    ViewMapping m;
    m.type = ProjectionType::Perspective;
    m.projectionReferencePoint = {0, 0, 2};
    change(m);
    return viewMapping(m).error();
  };
  EXPECT_EQ(error([](ViewMapping& m) { m.window.uMax = m.window.uMin; }),
            ViewMappingError::EmptyWindow);
  EXPECT_EQ(error([](ViewMapping& m) { m.window.vMax = -5; }), ViewMappingError::EmptyWindow);
  EXPECT_EQ(error([](ViewMapping& m) { m.window.vMax = std::nan(""); }),
            ViewMappingError::EmptyWindow);
  EXPECT_EQ(error([](ViewMapping& m) { m.backPlaneDistance = 1; }),
            ViewMappingError::BackPlaneNotBehindFrontPlane);
  EXPECT_EQ(error([](ViewMapping& m) { m.viewPlaneDistance = 2; }),
            ViewMappingError::ReferencePointOnViewPlane);
  EXPECT_EQ(error([](ViewMapping& m) { m.frontPlaneDistance = 2; }),
            ViewMappingError::ReferencePointNotBeforeFrontPlane);
  ViewMapping parallel;
  parallel.projectionReferencePoint = {0, 0, 0.5};
  EXPECT_TRUE(viewMapping(parallel).has_value());  // the front plane may lie before it
}

}  // namespace
}  // namespace vides
