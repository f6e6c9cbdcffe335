// SPDX-License-Identifier: MIT
// Times as users type them.
#include "edit/time_text.hpp"

#include <gtest/gtest.h>

namespace vides {
namespace {

TEST(TimeText, SecondsMinutesHours) {
  EXPECT_EQ(parseTime("12.5"), 12.5);
  EXPECT_EQ(parseTime("12,5 s"), 12.5);
  EXPECT_EQ(parseTime(" 90s "), 90.0);
  EXPECT_EQ(parseTime("0"), 0.0);
  EXPECT_EQ(parseTime("1:04.5"), 64.5);
  EXPECT_EQ(parseTime("00:09.52"), 9.52);
  EXPECT_EQ(parseTime("2:21:17.8"), 8477.8);
  for (const char* none : {"", "s", ":", "1:", ":5", "-1", "1:60", "1:-2", "1.5:30", "1:2:3:4",
                           "ten", "12 frames", "inf", "nan"}) {
    EXPECT_FALSE(parseTime(none)) << none;
  }
}

}  // namespace
}  // namespace vides
