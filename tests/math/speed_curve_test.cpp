// SPDX-License-Identifier: MIT
// Speed curves against the reference, and the limiter's promise on random curves.
#include "math/speed_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "math/random.hpp"
#include "math/reference_data.hpp"

namespace vides {
namespace {

using test::Json;
using test::Random;

std::optional<double> optionalNumber(const Json& j) {
  return j.is_null() ? std::nullopt : std::optional<double>(j.get<double>());
}

SpeedValues randomValues(Random& random) {
  SpeedValues values;
  for (double& v : values) v = random.coin() ? random.between(1, 100) : (random.coin() ? 1 : 100);
  return values;
}

TEST(SpeedCurve, MatchesTheReference) {
  const Json data = test::reference("05_speed_curve.json");
  for (const Json& c : data.at("curves")) {
    const std::string name = c.at("name");
    const SpeedCurve curve(c.at("values").get<SpeedValues>(), optionalNumber(c.at("prev_end")),
                           optionalNumber(c.at("next_begin")));
    const Json& expected = c.at("limited");
    const auto near = [&](double actual, const Json& e, const char* what) {
      const double value = e.get<double>();
      EXPECT_NEAR(actual, value, 1e-12 * std::max(1.0, std::abs(value))) << name << ' ' << what;
    };
    near(curve.mean(), expected.at("mean"), "mean");
    for (std::size_t j = 0; j < 10; ++j) {
      near(curve.slopes()[j], expected.at("slopes_per_knot").at(j), "slope");
    }
    for (std::size_t k = 0; k < expected.at("t").size(); ++k) {
      const double tau = expected.at("t").at(k);
      near(curve.at(tau), expected.at("f").at(k), "f");
      near(curve.integral(tau), expected.at("F").at(k), "F");
      near(curve.progress(tau), expected.at("lambda_").at(k), "lambda");
    }
  }
  EXPECT_GE(data.at("curves").size(), 11u);
}

TEST(SpeedCurve, StaysBetweenOneAndAHundred) {
  Random random(5);
  for (int i = 0; i < 10000; ++i) {
    const std::optional<double> before =
        random.coin() ? std::optional(random.between(1, 100)) : std::nullopt;
    const SpeedCurve curve(randomValues(random), before, random.between(1, 100));
    for (int k = 0; k < 20; ++k) {
      const double f = curve.at(random.unit());
      ASSERT_GE(f, kMinSpeed - 1e-12);
      ASSERT_LE(f, kMaxSpeed + 1e-12);
    }
  }
}

TEST(SpeedCurve, TheUnlimitedCurveWouldLeave) {
  const SpeedValues values{100, 1, 1, 100, 1, 1, 100, 100, 1, 100};
  const SpeedCurve curve(values, 100.0, 100.0);
  EXPECT_NE(unlimitedSlopes(values, 100.0, 100.0), curve.slopes());
  EXPECT_DOUBLE_EQ(unlimitedSlopes(values, 100.0, 100.0)[1], -49.5);
  EXPECT_DOUBLE_EQ(curve.slopes()[1], 0.0);
}

TEST(SpeedCurve, IntegralIsTheIntegral) {
  // Against Simpson's rule, exact for each cubic piece.
  Random random(6);
  for (int i = 0; i < 1000; ++i) {
    const SpeedCurve curve(randomValues(random), random.between(1, 100));
    double sum = 0.0;
    for (int j = 0; j < 9; ++j) {
      const double lo = j / 9.0, hi = (j + 1) / 9.0;
      sum += (curve.at(lo) + 4 * curve.at(0.5 * (lo + hi)) + curve.at(hi)) / 54.0;
      ASSERT_NEAR(curve.integral(hi), sum, 1e-11);
    }
    ASSERT_NEAR(curve.mean(), sum, 1e-11);
  }
}

TEST(SpeedCurve, ProgressRunsForwardFromZeroToOne) {
  Random random(7);
  for (int i = 0; i < 1000; ++i) {
    const SpeedCurve curve(randomValues(random));
    EXPECT_EQ(curve.progress(0.0), 0.0);
    EXPECT_EQ(curve.progress(1.0), 1.0);
    EXPECT_EQ(curve.integral(1.0), curve.mean());
    double last = 0.0;
    for (int k = 1; k <= 300; ++k) {
      const double now = curve.progress(k / 300.0);
      ASSERT_GT(now, last);
      last = now;
    }
  }
}

TEST(SpeedCurve, ConstantIsExact) {
  const SpeedCurve curve;
  EXPECT_EQ(curve.mean(), 50.0);
  for (double tau = 0; tau <= 1; tau += 1.0 / 64) {
    EXPECT_EQ(curve.at(tau), 50.0);
    EXPECT_NEAR(curve.progress(tau), tau, 1e-15);
  }
}

TEST(SpeedCurve, HitsItsValuesAndMeetsItsNeighbours) {
  const SpeedValues values{30, 42, 55, 61, 58, 50, 44, 47, 52, 50};
  const SpeedCurve curve(values, 25.0, 60.0);
  for (std::size_t j = 0; j < 10; ++j) {
    EXPECT_NEAR(curve.at(static_cast<double>(j) / 9.0), values[j], 1e-12);
  }
  EXPECT_DOUBLE_EQ(curve.slopes()[0], 0.5 * (42 - 25));
  EXPECT_DOUBLE_EQ(curve.slopes()[9], 0.5 * (60 - 52));
}

TEST(SpeedCurve, DerivativeIsThatOfTheSpeed) {
  const SpeedCurve curve({10, 90, 20, 50, 50, 1, 100, 100, 3, 40}, 60.0, 5.0);
  for (int i = 0; i < 500; ++i) {
    const double tau = (i + 0.37) / 500;
    constexpr double kStep = 1e-6;
    const double slope = (curve.at(tau + kStep) - curve.at(tau - kStep)) / (2 * kStep);
    EXPECT_NEAR(curve.derivative(tau), slope, 1e-4 * std::max(1.0, std::abs(slope))) << tau;
  }
  EXPECT_DOUBLE_EQ(curve.derivative(0.0), 9 * curve.slopes()[0]);
  EXPECT_DOUBLE_EQ(curve.derivative(1.0), 9 * curve.slopes()[9]);
}

TEST(SpeedCurve, UnlimitedIsTheHandsCurve) {
  const SpeedValues values{50, 50, 100, 100, 1, 1, 50, 50, 50, 50};
  const SpeedCurve drawn = SpeedCurve::unlimited(values, 50.0, 50.0);
  EXPECT_EQ(drawn.slopes(), unlimitedSlopes(values, 50.0, 50.0));
  double most = 0, least = 200;
  for (int i = 0; i <= 900; ++i) {
    most = std::max(most, drawn.at(i / 900.0));
    least = std::min(least, drawn.at(i / 900.0));
  }
  EXPECT_GT(most, kMaxSpeed);
  EXPECT_LT(least, kMinSpeed);
  // Where nothing is limited both are the same.
  const SpeedValues calm{50, 55, 60, 62, 60, 55, 50, 45, 40, 41};
  EXPECT_EQ(SpeedCurve::unlimited(calm, 50.0, 45.0), SpeedCurve(calm, 50.0, 45.0));
}

}  // namespace
}  // namespace vides
