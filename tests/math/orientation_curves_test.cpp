// SPDX-License-Identifier: MIT
// Slerp, Schlag's construction and the spherical Bezier piece: reference values and properties.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "math/quaternion.hpp"
#include "math/random.hpp"
#include "math/reference_data.hpp"

namespace vides {
namespace {

using test::difference;
using test::Json;
using test::quaternion;
using test::Random;

constexpr double kPi = std::numbers::pi;

double lengthOf(const Quaternion& q) {
  return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
}

// Two ends at an angle on the 3-sphere; every third pair is tiny, every third close to opposite.
struct Pair {
  Quaternion a, b;
  double angle;
};
Pair anyPair(Random& random, int i) {
  const Quaternion a = random.orientation();
  double angle = random.between(0.01, 3.1);
  if (i % 3 == 1) angle = random.magnitude(-18, -1);
  if (i % 3 == 2) angle = kPi - random.magnitude(-6, -1);
  return {a, exp(angle * random.direction()) * a, angle};
}

TEST(Slerp, MatchesTheReference) {
  const Json data = test::reference("03_quaternion_curves.json");
  for (const Json& c : data.at("blocks").at(0).at("cases")) {
    const Quaternion a = quaternion(c.at("a")), b = quaternion(c.at("b"));
    const double angle = c.at("angle");
    EXPECT_NEAR(angleOnSphere(a, b), angle, 1e-15) << c.at("name");
    const double tolerance = std::sin(angle) < 1e-2 ? 1e-12 : 1e-13;
    for (std::size_t k = 0; k < c.at("t").size(); ++k) {
      EXPECT_LT(difference(slerp(a, b, c.at("t").at(k)), quaternion(c.at("slerp").at(k))),
                tolerance)
          << c.at("name") << " t = " << c.at("t").at(k);
    }
  }
}

TEST(Schlag, MatchesTheReference) {
  const Json data = test::reference("03_quaternion_curves.json");
  int compared = 0;
  for (const Json& c : data.at("blocks").at(1).at("cases")) {
    std::vector<Quaternion> q;
    for (const Json& key : c.at("keys_canonical")) q.push_back(quaternion(key));
    for (const Json& s : c.at("segments")) {
      const std::size_t i = s.at("i");
      const Quaternion first = i > 0 ? q[i - 1] : slerp(q[1], q[0], 2.0);
      const Quaternion last = i + 2 < q.size() ? q[i + 2] : slerp(q[i], q[i + 1], 2.0);
      const SchlagCurve curve(first, q[i], q[i + 1], last);
      for (std::size_t k = 0; k < s.at("t").size(); ++k, ++compared) {
        EXPECT_LT(difference(curve.at(s.at("t").at(k)), quaternion(s.at("schlag_uniform").at(k))),
                  1e-13)
            << c.at("name") << ", segment " << i << ", t = " << s.at("t").at(k);
      }
    }
  }
  EXPECT_GE(compared, 200);
}

TEST(Slerp, IsTheRotationByAShareOfTheAngle) {
  // Independently: exp(t log(b a^-1)) a.
  Random random(31);
  for (int i = 0; i < 10000; ++i) {
    const Pair p = anyPair(random, i);
    const double t = random.between(-1, 2);
    const Quaternion expected = exp(t * log(p.b * glm::conjugate(p.a))) * p.a;
    ASSERT_LT(difference(slerp(p.a, p.b, t), expected), 5e-15 / std::min(1.0, kPi - p.angle))
        << p.angle;
  }
}

TEST(Slerp, TinyAnglesDivideEvenly) {
  // The way from a grows with t to the last digit that the ends have.
  const Quaternion a{1, 0, 0, 0};
  for (const double angle : {1e-4, 1e-8, 1e-12, 1e-15, 1e-100}) {
    const Quaternion b{std::cos(angle), std::sin(angle), 0, 0};
    for (const double t : {-1.0, 0.25, 0.5, 2.0}) {
      EXPECT_NEAR(std::asin(slerp(a, b, t).x) / angle, t, 1e-14) << angle;
    }
  }
}

TEST(Slerp, EndsAreExact) {
  Random random(32);
  for (int i = 0; i < 10000; ++i) {
    const Pair p = anyPair(random, i);
    ASSERT_EQ(slerp(p.a, p.b, 0.0), p.a);
    ASSERT_EQ(slerp(p.a, p.b, 1.0), p.b);
    // and nothing jumps there
    ASSERT_LT(difference(slerp(p.a, p.b, 1e-13), p.a), 1e-12);
    ASSERT_LT(difference(slerp(p.a, p.b, 1.0 - 1e-13), p.b), 1e-12);
  }
}

TEST(Slerp, IsExactlyOdd) {
  Random random(33);
  for (int i = 0; i < 10000; ++i) {
    const Pair p = anyPair(random, i);
    const double t = random.between(-2, 3);
    ASSERT_EQ(slerp(-p.a, -p.b, t), -slerp(p.a, p.b, t));
    const SlerpArc arc(p.a, p.b);
    ASSERT_EQ(arc.at(t), slerp(p.a, p.b, t));
  }
}

TEST(Slerp, StaysUnit) {
  Random random(34);
  for (int i = 0; i < 10000; ++i) {
    const Pair p = anyPair(random, i);
    ASSERT_NEAR(lengthOf(slerp(p.a, p.b, random.between(-2, 3))), 1.0, 2e-15) << p.angle;
  }
}

TEST(Slerp, AntipodalEndsTakeOneFixedWay) {
  Random random(35);
  for (int i = 0; i < 1000; ++i) {
    const Quaternion a = random.orientation();
    const Quaternion middle = slerp(a, -a, 0.5);
    ASSERT_NEAR(lengthOf(middle), 1.0, 1e-15);
    ASSERT_NEAR(angleOnSphere(a, middle), kPi / 2, 1e-15);
    ASSERT_EQ(middle, slerp(a, -a, 0.5));
    ASSERT_EQ(slerp(-a, a, 0.5), -middle);
    ASSERT_EQ(slerp(a, -a, 1.0), -a);
  }
}

TEST(Slerp, OnePointStaysOnePoint) {
  Random random(36);
  for (int i = 0; i < 1000; ++i) {
    const Quaternion a = random.orientation();
    ASSERT_EQ(slerp(a, a, random.between(-2, 3)), a);
    // Ends that differ in length alone, by rounding.
    const Quaternion b = a * (1.0 + 4e-16);
    ASSERT_LT(difference(slerp(a, b, random.between(-2, 3)), a), 2e-15);
  }
}

TEST(Slerp, IsContinuousOverTinyAngles) {
  Random random(37);
  for (int i = 0; i < 10000; ++i) {
    const Quaternion a = random.orientation();
    const Vec3 axis = random.direction();
    const double angle = random.magnitude(-18, 0), t = random.between(-1, 2);
    const Quaternion one = slerp(a, exp(angle * axis) * a, t);
    const Quaternion two = slerp(a, exp(1.001 * angle * axis) * a, t);
    ASSERT_LE(angleOnSphere(one, two), 0.003 * angle + 2e-15);
  }
}

template <typename Curve>
class OrientationCurve : public testing::Test {};
using Curves = testing::Types<SchlagCurve, SphericalBezier>;
TYPED_TEST_SUITE(OrientationCurve, Curves);

// What at(0) and at(1) must be: inner points of Schlag's piece, outer ones of Bezier's.
const Quaternion& startOf(const SchlagCurve*, const Quaternion (&q)[4]) { return q[1]; }
const Quaternion& endOf(const SchlagCurve*, const Quaternion (&q)[4]) { return q[2]; }
const Quaternion& startOf(const SphericalBezier*, const Quaternion (&q)[4]) { return q[0]; }
const Quaternion& endOf(const SphericalBezier*, const Quaternion (&q)[4]) { return q[3]; }

// A chain in which each is within a right angle of the one before, or close to it, or the same.
void chain(Random& random, Quaternion (&q)[4]) {
  q[0] = random.orientation();
  for (int k = 1; k < 4; ++k) {
    const double angle = random.coin()   ? random.between(0, kPi / 2)
                         : random.coin() ? random.magnitude(-17, -1)
                                         : 0.0;
    q[k] = exp(angle * random.direction()) * q[k - 1];
  }
}

TYPED_TEST(OrientationCurve, EndsExactlyAndIsOddAndUnit) {
  Random random(41);
  const TypeParam* tag = nullptr;
  for (int i = 0; i < 10000; ++i) {
    Quaternion q[4];
    chain(random, q);
    const TypeParam curve(q[0], q[1], q[2], q[3]), other(-q[0], -q[1], -q[2], -q[3]);
    ASSERT_EQ(curve.at(0.0), startOf(tag, q));
    ASSERT_EQ(curve.at(1.0), endOf(tag, q));
    ASSERT_LT(difference(curve.at(1e-12), startOf(tag, q)), 1e-10);
    ASSERT_LT(difference(curve.at(1.0 - 1e-12), endOf(tag, q)), 1e-10);
    const double t = random.unit();
    const Quaternion at = curve.at(t);
    ASSERT_NEAR(lengthOf(at), 1.0, 1e-14);
    ASSERT_EQ(other.at(t), -at);
  }
}

TYPED_TEST(OrientationCurve, RunsBackwardsAlike) {
  Random random(42);
  for (int i = 0; i < 10000; ++i) {
    Quaternion q[4];
    chain(random, q);
    const TypeParam curve(q[0], q[1], q[2], q[3]), back(q[3], q[2], q[1], q[0]);
    const double t = random.unit();
    ASSERT_LT(difference(curve.at(t), back.at(1.0 - t)), 1e-13);
  }
}

TEST(SphericalBezier, AroundOneAxisIsTheCubicOfTheAngle) {
  // With all four about y, slerp is linear in the angle and the curve the plain Bezier cubic.
  const double angle[4] = {0.1, 0.7, 1.1, 0.4};
  Quaternion q[4];
  for (int k = 0; k < 4; ++k) q[k] = exp(Vec3{0, angle[k], 0});
  const SphericalBezier curve(q[0], q[1], q[2], q[3]);
  for (double t = 0; t <= 1; t += 1.0 / 16) {
    const double s = 1 - t;
    const double expected = s * s * s * angle[0] + 3 * s * s * t * angle[1] +
                            3 * s * t * t * angle[2] + t * t * t * angle[3];
    EXPECT_LT(difference(curve.at(t), exp(Vec3{0, expected, 0})), 1e-15);
  }
}

TEST(Schlag, AroundOneAxisIsCatmullRom) {
  const double angle[4] = {0.1, 0.7, 1.1, 0.4};
  Quaternion q[4];
  for (int k = 0; k < 4; ++k) q[k] = exp(Vec3{angle[k], 0, 0});
  // At 1/2: (-P0 + 9 P1 + 9 P2 - P3)/16.
  const double expected = (-0.1 + 9 * 0.7 + 9 * 1.1 - 0.4) / 16;
  EXPECT_LT(difference(SchlagCurve(q[0], q[1], q[2], q[3]).at(0.5), exp(Vec3{expected, 0, 0})),
            1e-15);
}

}  // namespace
}  // namespace vides
