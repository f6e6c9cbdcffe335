// SPDX-License-Identifier: MIT
// The ease presets: values by hand, means, symmetry.
#include "edit/ease.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vides {
namespace {

TEST(Ease, ValuesByHand) {
  EXPECT_EQ(easeValues("constant"), (SpeedValues{50, 50, 50, 50, 50, 50, 50, 50, 50, 50}));
  const SpeedValues parabola = *easeValues("in-parabola");
  EXPECT_EQ(parabola[0], 1.0);
  EXPECT_DOUBLE_EQ(parabola[3], 100.0 / 3.0);
  EXPECT_EQ(parabola[9], 100.0);
  // The lecture's v(t) = v0 cos(pi (t - t0) / 2 t0) with t0 = 1.
  const SpeedValues sine = *easeValues("in-sine");
  EXPECT_DOUBLE_EQ(sine[9], 25.0 * std::numbers::pi);
  EXPECT_NEAR(sine[6], sine[9] * std::cos(0.5 * std::numbers::pi * (6.0 / 9.0 - 1.0)), 1e-12);
  const SpeedValues ramp = *easeValues("in-out-acceleration");
  const SpeedValues byHand{1, 25, 50, 75, 75, 75, 75, 50, 25, 1};
  for (std::size_t j = 0; j < 10; ++j) EXPECT_NEAR(ramp[j], byHand[j], 1e-12);
}

TEST(Ease, InIsOutBackwardsAndInOutIsItsOwn) {
  for (const std::string form : {"sine", "parabola", "acceleration"}) {
    const SpeedValues in = *easeValues("in-" + form), out = *easeValues("out-" + form);
    const SpeedValues both = *easeValues("in-out-" + form);
    for (std::size_t j = 0; j < 10; ++j) {
      EXPECT_NEAR(in[j], out[9 - j], 1e-12) << form;
      EXPECT_NEAR(both[j], both[9 - j], 1e-12) << form;
    }
  }
}

TEST(Ease, AllNamesInRangeWithTheBaseSpeedAsMean) {
  EXPECT_EQ(easeNames().size(), 10u);
  for (const std::string_view name : easeNames()) {
    const auto values = easeValues(name);
    ASSERT_TRUE(values) << name;
    for (const double v : *values) EXPECT_TRUE(v >= 1.0 && v <= 100.0) << name;
    EXPECT_NEAR(SpeedCurve(*values).mean(), kBaseSpeed, 2.0) << name;
  }
  EXPECT_FALSE(easeValues("in-elastic"));
}

}  // namespace
}  // namespace vides
