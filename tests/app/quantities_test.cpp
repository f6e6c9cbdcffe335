// SPDX-License-Identifier: MIT
// Numbers as the instruments tell them: thousands, units, times.
#include "panels/quantities.hpp"

#include <gtest/gtest.h>

namespace vides {
namespace {

class Quantities : public testing::Test {
 protected:
  Ui ui(bool decimalComma = false) {
    return Ui({fonts_, theme_, words_, tell_, hint_, registry_, memory_, 1.0f, 0.0, decimalComma});
  }
  Fonts fonts_;
  Theme theme_;
  Words words_ = [](std::string_view key) { return std::string(key); };
  Tell tell_;
  ShortcutHint hint_;
  WidgetRegistry registry_;
  UiMemory memory_;
};

TEST_F(Quantities, ThousandsStandApartFromFiveDigitsOn) {
  EXPECT_EQ(grouped(ui(), 9999.0, 0), "9999");
  EXPECT_EQ(grouped(ui(), 10000.0, 0), "10\u202f000");
  EXPECT_EQ(grouped(ui(), -1234567.25, 2), "\u22121\u202f234\u202f567.25");
  EXPECT_EQ(grouped(ui(true), 123456.5, 1), "123\u202f456,5");
  EXPECT_EQ(grouped(ui(), std::int64_t{211944}), "211\u202f944");
  fonts_.plain = true;
  EXPECT_EQ(grouped(ui(), 10000.0, 0), "10 000");
}

TEST_F(Quantities, DecimalsFollowTheSize) {
  EXPECT_EQ(measured(ui(), 0.40449), "0.404");
  EXPECT_EQ(measured(ui(), 0.0), "0.000");
  EXPECT_EQ(measured(ui(), 1e-17), "0.000");
  EXPECT_EQ(measured(ui(), 0.0413), "0.0413");
  EXPECT_EQ(measured(ui(), 0.000267), "0.000267");
  EXPECT_EQ(measured(ui(), 137.99), "137.99");
  EXPECT_EQ(measured(ui(), 2117.702), "2117.7");
  EXPECT_EQ(measured(ui(), 740119.4), "740\u202f119");
  EXPECT_EQ(measured(ui(), -4.2e12), "\u22124.200e12");
  EXPECT_EQ(withUnit("63.7", "\u00b0/s"), "63.7 \u00b0/s");
  EXPECT_EQ(withUnit("45", "\u00b0"), "45\u00b0");
}

TEST_F(Quantities, TimesHaveTheFormOfTheWholeFlight) {
  EXPECT_EQ(timeText(ui(), 31.12, 31.12, 2), "31.12 s");
  EXPECT_EQ(timeText(ui(true), 9.52, 31.12, 2), "9,52 s");
  EXPECT_EQ(timeText(ui(), 30.0, 59.999, 0), "30 s");
  EXPECT_EQ(timeText(ui(), 9.5, 60.0, 2), "0:09.50");
  EXPECT_EQ(timeText(ui(), 69.999, 600.0, 2), "1:10.00");
  EXPECT_EQ(timeText(ui(), 90.0, 600.0, 0), "1:30");
  EXPECT_EQ(timeText(ui(), 0.36, 8477.8, 2), "0:00:00.36");
  EXPECT_EQ(timeText(ui(), 8477.8, 8477.8, 2), "2:21:17.80");
  EXPECT_EQ(timeText(ui(), 7200.0, 8477.8, 0), "2:00:00");
  // 29 frames at 100 a second; in floating point a little less.
  EXPECT_EQ(timeText(ui(), 29 / 100.0, 10.0, 2), "0.29 s");
}

TEST_F(Quantities, PaddedTimesOfAFlightAreAsLong) {
  EXPECT_EQ(paddedTime(ui(), 9.52, 31.12, 2), "00:09.52");
  EXPECT_EQ(paddedTime(ui(), 9.52, 9.9, 2), "00:09.52");
  EXPECT_EQ(paddedTime(ui(), 9.52, 700.0, 2), "00:09.52");
  EXPECT_EQ(paddedTime(ui(), 9.52, 3600.0 * 12, 2), "00:00:09.52");
  for (const double span : {5.0, 42.0, 75.0, 1000.0, 5000.0, 50000.0}) {
    for (double t = 0.0; t < span; t += span / 97.0) {
      ASSERT_EQ(paddedTime(ui(), t, span, 2).size(), paddedTime(ui(), span, span, 2).size()) << t;
    }
  }
}

}  // namespace
}  // namespace vides
