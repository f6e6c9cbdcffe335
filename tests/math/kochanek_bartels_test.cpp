// SPDX-License-Identifier: MIT
// Tangents, coefficients and points of Kochanek-Bartels curves against the reference; ends,
// coincident neighbours.
#include "math/kochanek_bartels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "math/random.hpp"
#include "math/reference_data.hpp"

namespace vides {
namespace {

using test::difference;
using test::Json;
using test::Random;
using test::vec3;

void expectNear(const Vec3& actual, const Json& expected, const std::string& what) {
  const Vec3 e = vec3(expected);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(actual[k], e[k], 2e-15 * std::max(1.0, std::abs(e[k]))) << what;
  }
}

CubicSegment segmentOf(const std::vector<Vec3>& p, const std::vector<Shape>& shapes,
                       std::size_t i) {
  return kochanekBartelsSegment(i > 0 ? &p[i - 1] : nullptr, p[i], shapes[i], p[i + 1],
                                shapes[i + 1], i + 2 < p.size() ? &p[i + 2] : nullptr);
}

TEST(KochanekBartels, MatchesTheReference) {
  const Json data = test::reference("01_kb_splines.json");
  int segments = 0;
  for (const Json& c : data.at("cases")) {
    std::vector<Vec3> points;
    std::vector<Shape> shapes;
    for (const Json& p : data.at("point_sets").at(c.at("points_set").get<std::string>())) {
      points.push_back(vec3(p));
    }
    for (const Json& s : c.at("tcb")) shapes.push_back({s.at(0), s.at(1), s.at(2)});
    ASSERT_EQ(points.size(), shapes.size());
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Json& expected = c.at("segments").at(i);
      const std::string what = c.at("points_set").get<std::string>() + ", " +
                               c.at("tcb_name").get<std::string>() + ", segment " +
                               std::to_string(i);
      const CubicSegment q = segmentOf(points, shapes, i);
      expectNear(q.c, expected.at("R_out"), what + " R_out");
      expectNear(q.derivative(1.0), expected.at("R_in"), what + " R_in");
      if (expected.contains("a")) {
        expectNear(q.a, expected.at("a"), what + " a");
        expectNear(q.b, expected.at("b"), what + " b");
        expectNear(q.d, expected.at("d"), what + " d");
      }
      for (std::size_t k = 0; k < expected.at("u").size(); ++k) {
        const double u = expected.at("u").at(k);
        expectNear(q.point(u), expected.at("P").at(k), what + " P");
        if (expected.contains("dP")) {
          expectNear(q.derivative(u), expected.at("dP").at(k), what + " dP");
        }
      }
      ++segments;
    }
  }
  EXPECT_GE(segments, 100);
}

TEST(KochanekBartels, ZeroShapeIsCatmullRom) {
  // By hand, from Q(1/2) = (-P0 + 9 P1 + 9 P2 - P3)/16.
  const Vec3 p0{-1, 0, 0}, p1{0, 1, 0}, p2{1, 0, 1}, p3{0, -1, 1};
  const CubicSegment q = kochanekBartelsSegment(&p0, p1, {}, p2, {}, &p3);
  EXPECT_LT(difference(q.point(0.5), Vec3{10.0 / 16, 10.0 / 16, 8.0 / 16}), 1e-15);
  EXPECT_LT(difference(q.c, 0.5 * (p2 - p0)), 1e-15);
}

TEST(KochanekBartels, PositiveBiasOvershoots) {
  // Bias 1: the tangent follows the chord that arrives, so the curve goes on beyond the key.
  const Vec3 p0{-1, 0, 0}, p1{0, 0, 0}, p2{0, 1, 0};
  const CubicSegment q = kochanekBartelsSegment(&p0, p1, {0, 0, 1}, p2, {}, nullptr);
  EXPECT_LT(difference(q.c, Vec3{1, 0, 0}), 1e-15);
  EXPECT_GT(q.point(0.25).x, 0.0);
}

TEST(KochanekBartels, EndTangentNeverStartsBackwards) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 p0 = random.inCube(), p1 = random.inCube(), p2 = random.inCube();
    const Shape s0 = random.shape(), s1 = random.shape();
    const Vec3 start = kochanekBartelsSegment(nullptr, p0, s0, p1, s1, &p2).c;
    ASSERT_GE(glm::dot(start, p1 - p0), -1e-12);
    const Vec3 end = kochanekBartelsSegment(&p2, p1, s1, p0, s0, nullptr).derivative(1.0);
    ASSERT_GE(glm::dot(end, p0 - p1), -1e-12);
  }
}

TEST(KochanekBartels, TwoPointsAreAStraightLine) {
  const Vec3 p0{-1, 0.5, 0}, p1{0, 1, 1};
  const CubicSegment q =
      kochanekBartelsSegment(nullptr, p0, {0.5, 1, -1}, p1, {-0.5, -1, 1}, nullptr);
  const Vec3 chord = p1 - p0;
  EXPECT_LT(difference(q.c, 0.5 * chord), 1e-15);
  EXPECT_LT(difference(q.derivative(1.0), 1.5 * chord), 1e-15);
  for (double u = 0; u <= 1; u += 0.125) {
    EXPECT_LT(glm::length(glm::cross(q.point(u) - p0, chord)), 1e-15);
  }
}

TEST(KochanekBartels, ReversedOrderGivesTheReversedCurve) {
  Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 p0 = random.inCube(), p1 = random.inCube(), p2 = random.inCube(),
               p3 = random.inCube();
    const Shape s1 = random.shape(), s2 = random.shape();
    const Shape r1{s1.tension, s1.continuity, -s1.bias}, r2{s2.tension, s2.continuity, -s2.bias};
    const bool open = random.coin();
    const CubicSegment q = kochanekBartelsSegment(open ? nullptr : &p0, p1, s1, p2, s2, &p3);
    const CubicSegment r = kochanekBartelsSegment(&p3, p2, r2, p1, r1, open ? nullptr : &p0);
    const double u = random.unit();
    ASSERT_LT(difference(q.point(u), r.point(1.0 - u)), 1e-14);
  }
}

TEST(KochanekBartels, PassesThroughItsPoints) {
  Random random(3);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 p0 = random.inCube(), p1 = random.inCube(), p2 = random.inCube(),
               p3 = random.inCube();
    const Shape s1 = random.shape(), s2 = random.shape();
    const CubicSegment q = kochanekBartelsSegment(random.coin() ? &p0 : nullptr, p1, s1, p2, s2,
                                                  random.coin() ? &p3 : nullptr);
    ASSERT_EQ(q.point(0.0), p1);
    ASSERT_LT(difference(q.point(1.0), p2), 2e-14);
  }
}

TEST(KochanekBartels, NeighboursAtOnePlaceEndTheCurve) {
  const Vec3 p0{-0.5, 0, 0}, p1{0, 0.5, 0}, p2{0.5, 0.25, 0.1};
  const Vec3 near = p0 + Vec3{0.9e-9, 0, 0}, far = p0 + Vec3{1.1e-9, 0, 0};
  const Shape s{0.25, 0.5, 0.75};
  EXPECT_EQ(kochanekBartelsSegment(&near, p0, s, p1, s, &p2),
            kochanekBartelsSegment(nullptr, p0, s, p1, s, &p2));
  EXPECT_NE(kochanekBartelsSegment(&far, p0, s, p1, s, &p2),
            kochanekBartelsSegment(nullptr, p0, s, p1, s, &p2));
  // The piece between has no length and no loop, whatever lies beyond.
  const CubicSegment between = kochanekBartelsSegment(&p2, p0, s, p0, s, &p1);
  for (double u = 0; u <= 1; u += 0.125) EXPECT_EQ(between.point(u), p0);
}

TEST(KochanekBartels, OneSidedTangentsAgreeWithoutContinuity) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    Shape s = random.shape();
    const Vec3 a = random.inCube(), b = random.inCube(), c = random.inCube();
    s.continuity = 0.0;
    const Tangents smooth = kochanekBartelsTangents(a, b, c, s);
    ASSERT_LT(difference(smooth.incoming, smooth.outgoing), 1e-15);
  }
}

}  // namespace
}  // namespace vides
