// SPDX-License-Identifier: MIT
// Ten values for a wished course: kept ends, met means, small errors.
#include "math/speed_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "math/random.hpp"

namespace vides {
namespace {

// The course of a speed given as a function, by Simpson's rule.
template <class Speed>
SpeedWish wishFor(Speed speed) {
  constexpr int kSteps = SpeedWish::kSteps;
  SpeedWish wish;
  double sum = 0.0;
  std::array<double, kSteps + 1> way{};
  for (std::size_t i = 0; i < kSteps; ++i) {
    const double a = static_cast<double>(i) / kSteps, b = static_cast<double>(i + 1) / kSteps;
    sum += (speed(a) + 4.0 * speed(0.5 * (a + b)) + speed(b)) / (6.0 * kSteps);
    way[i + 1] = sum;
  }
  for (std::size_t i = 0; i < wish.shares.size(); ++i) wish.shares[i] = way[i + 1] / sum;
  for (std::size_t j = 0; j < kSpeedValues; ++j) {
    wish.values[j] = speed(static_cast<double>(j) / 9.0);
  }
  wish.mean = sum;
  return wish;
}

SpeedCurve curveOf(const SpeedWish& wish) {
  return SpeedCurve(wish.values, wish.before, wish.after);
}

TEST(SpeedFit, FollowsSmoothSpeeds) {
  test::Random random(7);
  for (int trial = 0; trial < 50; ++trial) {
    const double a = random.between(-30, 30), b = random.between(0, 6), c = random.between(0, 5);
    std::vector<SpeedWish> wishes{wishFor([&](double t) { return 50 + a * std::sin(b * t + c); })};
    const double mean = *wishes[0].mean;
    fitSpeeds(wishes);
    EXPECT_LT(shareError(curveOf(wishes[0]), wishes[0]), 1e-4);
    EXPECT_NEAR(curveOf(wishes[0]).mean() / mean, 1.0, 1e-12);
  }
}

TEST(SpeedFit, KeepsEndsOnWhichOthersGoOn) {
  std::vector<SpeedWish> wishes{wishFor([](double t) { return 40 + 20 * t; })};
  SpeedWish& wish = wishes[0];
  wish.keepsFirst = wish.keepsLast = true;
  wish.values.front() = 44.0;
  wish.values.back() = 55.0;
  wish.before = 44.0;
  wish.after = 55.0;
  const double begun = shareError(curveOf(wish), wish);
  fitSpeeds(wishes);
  EXPECT_EQ(wish.values.front(), 44.0);
  EXPECT_EQ(wish.values.back(), 55.0);
  EXPECT_NEAR(curveOf(wish).mean(), 50.0, 1e-10);
  EXPECT_LT(shareError(curveOf(wish), wish), 0.8 * begun);
}

TEST(SpeedFit, StaysInRangeWhereTheWishGoesBeyond) {
  std::vector<SpeedWish> wishes{wishFor([](double t) { return 90 + 30 * std::sin(9 * t); })};
  for (double& v : wishes[0].values) v = std::min(v, kMaxSpeed);
  fitSpeeds(wishes);
  for (const double v : wishes[0].values) {
    EXPECT_GE(v, kMinSpeed);
    EXPECT_LE(v, kMaxSpeed);
  }
}

// Two curves, each of which goes on into the other, are found together.
TEST(SpeedFit, FindsNeighboursTogether) {
  const auto speed = [](double t) { return 45 + 25 * std::sin(5 * t); };
  std::vector<SpeedWish> wishes{wishFor([&](double t) { return speed(0.7 * t); }),
                                wishFor([&](double t) { return speed(0.7 + 0.3 * t); })};
  wishes[0].next = 1;
  wishes[1].previous = 0;
  fitSpeeds(wishes);
  const SpeedCurve first(wishes[0].values, std::nullopt, wishes[1].values.front());
  const SpeedCurve second(wishes[1].values, wishes[0].values.back(), std::nullopt);
  EXPECT_LT(shareError(first, wishes[0]), 3e-4);
  EXPECT_LT(shareError(second, wishes[1]), 3e-4);
  EXPECT_NEAR(first.mean() / *wishes[0].mean, 1.0, 1e-9);
  EXPECT_NEAR(second.mean() / *wishes[1].mean, 1.0, 1e-9);
}

}  // namespace
}  // namespace vides
