// SPDX-License-Identifier: MIT
// Arc lengths and their inverse against the reference; cusps, reversals, no length at all.
#include "math/arc_length.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/kochanek_bartels.hpp"
#include "math/random.hpp"
#include "math/reference_data.hpp"

namespace vides {
namespace {

using test::difference;
using test::Json;
using test::Random;
using test::vec3;

// A piece of one of the kinds that arc lengths go wrong on.
CubicSegment anySegment(Random& random, int kind) {
  const Vec3 p0 = random.inCube(), p1 = random.inCube(), before = random.inCube(),
             after = random.inCube();
  switch (kind % 6) {
    case 0:  // from keys, any shape
      return kochanekBartelsSegment(&before, p0, random.shape(), p1, random.shape(), &after);
    case 1: {  // a near cusp in the middle: crossed tangents, a little apart
      const Vec3 d = random.direction() * random.magnitude(-10, -1);
      const Vec3 r{1, 0.5, 0}, s{1, -0.5, 0};
      return CubicSegment::hermite({0, 0, 0}, 6.0 * s, {1, 0, 0}, 6.0 * r + d);
    }
    case 2: {  // Q' = (u - m)^2-like in one axis, tiny in another: a near cusp anywhere
      const double m = random.unit(), tiny = random.magnitude(-12, -2);
      return {{1.0 / 3, 0, 0}, {-m, 0.5, 0}, {m * m, -m, tiny}, p0};
    }
    case 3:  // zero tangents at one or both ends
      return CubicSegment::hermite(p0, random.coin() ? Vec3{0.0} : p1 - before, p1, Vec3{0.0});
    case 4: {  // straight, doubling back
      const Vec3 d = random.direction();
      return CubicSegment::hermite(p0, random.between(-6, 6) * d, p0 + random.between(-1, 1) * d,
                                   random.between(-6, 6) * d);
    }
    default: {  // tiny
      const double size = random.magnitude(-9, -3);
      return CubicSegment::hermite(p0, size * before, p0 + size * p1, size * after);
    }
  }
}

TEST(ArcLength, MatchesTheReference) {
  const Json data = test::reference("02_arclength.json");
  for (const Json& s : data.at("segments")) {
    const CubicSegment q{vec3(s.at("a")), vec3(s.at("b")), vec3(s.at("c")), vec3(s.at("d"))};
    const ArcLength table(q);
    const double length = s.at("length");
    const std::string what = s.at("length_str").get<std::string>();
    EXPECT_NEAR(table.length(), length, 1e-12 * length) << what;
    for (std::size_t k = 0; k < s.at("u").size(); ++k) {
      const double arc = s.at("fraction").at(k).get<double>() * length;
      const double u = table.parameterAt(q, arc);
      EXPECT_LE(difference(q.point(u), vec3(s.at("P").at(k))), 1e-11 * std::max(1.0, length))
          << what << " at " << k;
      EXPECT_NEAR(table.lengthAt(q, s.at("u").at(k)), arc, 2e-12 * length) << what << " at " << k;
    }
  }
  EXPECT_GE(data.at("segments").size(), 129u);
}

TEST(ArcLength, InverseReturnsToItsLength) {
  Random random(11);
  for (int i = 0; i < 30000; ++i) {
    const CubicSegment q = anySegment(random, i);
    const ArcLength table(q);
    const double length = table.length();
    ASSERT_TRUE(std::isfinite(length));
    for (int k = 0; k < 8; ++k) {
      // Shares everywhere, and close to both ends.
      const double share = k < 4    ? random.unit()
                           : k == 4 ? random.magnitude(-15, 0)
                           : k == 5 ? 1.0 - random.magnitude(-15, 0)
                                    : 0.125 * (k - 5);
      const double s = share * length;
      const double u = table.parameterAt(q, s);
      ASSERT_GE(u, 0.0);
      ASSERT_LE(u, 1.0);
      ASSERT_NEAR(table.lengthAt(q, u), s, 1e-12 * length) << "kind " << i % 6 << " case " << i;
    }
  }
}

// |Q'| summed in a way of its own: tanh-sinh between the minima of the speed, which a fine scan
// finds. Shares nothing with the table.
double slowLength(const CubicSegment& q) {
  const auto turn = [&](double u) { return glm::dot(q.derivative(u), q.secondDerivative(u)); };
  const auto part = [&](double lo, double hi) {
    const double h = 1.0 / 32, half = 0.5 * (hi - lo);
    double sum = 0.0;
    for (int k = -120; k <= 120; ++k) {
      const double t = h * k, w = 0.5 * std::numbers::pi * std::sinh(t);
      // Distance from the nearer end, so that nothing is lost there.
      const double edge = std::exp(-std::abs(w)) / std::cosh(w);
      const double u = w < 0 ? lo + half * edge : hi - half * edge;
      const double weight = 0.5 * std::numbers::pi * std::cosh(t) / (std::cosh(w) * std::cosh(w));
      sum += weight * glm::length(q.derivative(u));
    }
    return sum * h * half;
  };
  double length = 0.0, start = 0.0;
  const int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    double lo = static_cast<double>(i) / steps, hi = static_cast<double>(i + 1) / steps;
    if ((turn(lo) < 0.0) != (turn(hi) < 0.0)) {
      const bool rising = turn(lo) < 0.0;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (lo + hi);
        ((turn(middle) < 0.0) == rising ? lo : hi) = middle;
      }
      length += part(start, hi);
      start = hi;
    }
  }
  return length + part(start, 1.0);
}

TEST(ArcLength, LengthAgreesWithTanhSinh) {
  Random random(12);
  for (int i = 0; i < 600; ++i) {
    const CubicSegment q = anySegment(random, i);
    // Near cusps double exponential sums converge slowly; the bound is theirs there.
    const double bound = i % 6 == 1 || i % 6 == 2 ? 1e-8 : 2e-12;
    const double length = slowLength(q);
    ASSERT_NEAR(ArcLength(q).length(), length, bound * length) << "kind " << i % 6 << " case " << i;
  }
}

TEST(ArcLength, CuspsInClosedForm) {
  // The semicubical parabola Q = (u^2, u^3) from its cusp: s(u) = ((4 + 9u^2)^(3/2) - 8)/27.
  const CubicSegment q{{0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  const ArcLength table(q);
  const auto exact = [](double u) { return (std::pow(4 + 9 * u * u, 1.5) - 8) / 27; };
  EXPECT_NEAR(table.length(), exact(1), 1e-15);
  for (const double u : {1e-3, 0.01, 0.1, 0.5, 0.9, 0.999}) {
    EXPECT_NEAR(table.lengthAt(q, u), exact(u), 3e-15);
    EXPECT_NEAR(table.parameterAt(q, exact(u)), u, 1e-12 / u);
  }
  // The same with the cusp in the middle: v = 2u - 1.
  const CubicSegment both{{0, 8, 0}, {4, -12, 0}, {-4, 6, 0}, {1, -1, 0}};
  const ArcLength whole(both);
  EXPECT_NEAR(whole.length(), 2 * exact(1), 2e-15);
  EXPECT_NEAR(whole.parameterAt(both, exact(1)), 0.5, 1e-6);
}

TEST(ArcLength, DoublingBackCountsTheWayTwice) {
  // x = 0, 1, then back to 0 along a line: x = 4u(1-u), length 2; s(1/4) = 3/4.
  const CubicSegment q{{0, 0, 0}, {-4, 0, 0}, {4, 0, 0}, {0, 0, 0}};
  const ArcLength table(q);
  EXPECT_NEAR(table.length(), 2.0, 1e-15);
  EXPECT_NEAR(table.lengthAt(q, 0.25), 0.75, 1e-15);
  EXPECT_NEAR(table.parameterAt(q, 0.75), 0.25, 1e-14);
  EXPECT_NEAR(table.parameterAt(q, 1.25), 0.75, 1e-14);
  // A unit chord with tangents -6 at both ends turns twice: x = -14u^3 + 21u^2 - 6u.
  const CubicSegment there = CubicSegment::hermite({0, 0, 0}, {-6, 0, 0}, {1, 0, 0}, {-6, 0, 0});
  const auto x = [](double u) { return ((-14 * u + 21) * u - 6) * u; };
  const double root = std::sqrt(1.0 / 4 - 1.0 / 7);  // x' = 0 at 1/2 -+ root
  const double expected = 2 * std::abs(x(0.5 - root)) + x(0.5 + root) - x(0.5 - root);
  const double back = x(0.5 + root) - 1.0;  // equal to |x(1/2 - root)| by symmetry
  EXPECT_NEAR(back, std::abs(x(0.5 - root)), 1e-14);
  EXPECT_NEAR(ArcLength(there).length(), expected, 1e-14);
}

TEST(ArcLength, StraightLineIsProportional) {
  const CubicSegment q = CubicSegment::hermite({0, 0, 0}, {3, 4, 0}, {3, 4, 0}, {3, 4, 0});
  const ArcLength table(q);
  EXPECT_DOUBLE_EQ(table.length(), 5.0);
  for (double u = 0; u <= 1; u += 1.0 / 16) EXPECT_NEAR(table.parameterAt(q, 5 * u), u, 1e-15);
}

TEST(ArcLength, NoLengthAtAll) {
  const CubicSegment q{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0.3, 0.2, 0.1}};
  const ArcLength table(q);
  EXPECT_EQ(table.length(), 0.0);
  EXPECT_EQ(table.lengthAt(q, 0.5), 0.0);
  EXPECT_EQ(table.parameterAt(q, 0.0), 0.0);
  EXPECT_EQ(table.parameterAt(q, 1.0), 1.0);
  EXPECT_EQ(ArcLength().length(), 0.0);
  EXPECT_EQ(ArcLength().lengthAt(q, 0.5), 0.0);
  EXPECT_EQ(ArcLength().parameterAt(q, 0.0), 0.0);
}

TEST(ArcLength, EndsAreExactAndArgumentsAreClamped) {
  Random random(13);
  for (int i = 0; i < 3000; ++i) {
    const CubicSegment q = anySegment(random, i);
    const ArcLength table(q);
    ASSERT_EQ(table.parameterAt(q, 0.0), 0.0);
    ASSERT_EQ(table.parameterAt(q, -1.0), 0.0);
    ASSERT_EQ(table.parameterAt(q, table.length()), 1.0);
    ASSERT_EQ(table.parameterAt(q, 2.0 * table.length()), 1.0);
    ASSERT_EQ(table.parameterAt(q, std::numeric_limits<double>::quiet_NaN()), 0.0);
    ASSERT_EQ(table.lengthAt(q, 0.0), 0.0);
    ASSERT_EQ(table.lengthAt(q, -0.5), 0.0);
    ASSERT_EQ(table.lengthAt(q, 1.0), table.length());
    ASSERT_EQ(table.lengthAt(q, 1.5), table.length());
  }
}

TEST(ArcLength, GrowsWithTheParameter) {
  Random random(14);
  for (int i = 0; i < 3000; ++i) {
    const CubicSegment q = anySegment(random, i);
    const ArcLength table(q);
    double s = 0.0, u = 0.0;
    for (int k = 1; k <= 64; ++k) {
      const double nextS = table.lengthAt(q, k / 64.0);
      const double nextU = table.parameterAt(q, table.length() * k / 64.0);
      ASSERT_GE(nextS, s - 1e-13 * table.length());
      ASSERT_GE(nextU, u);
      s = nextS;
      u = nextU;
    }
  }
}

TEST(ArcLength, IsNeverShorterThanTheChord) {
  Random random(15);
  for (int i = 0; i < 10000; ++i) {
    const CubicSegment q = anySegment(random, i);
    const double length = ArcLength(q).length();
    ASSERT_GE(length * (1 + 1e-12) + 1e-16, glm::distance(q.point(0), q.point(1)));
  }
}

}  // namespace
}  // namespace vides
