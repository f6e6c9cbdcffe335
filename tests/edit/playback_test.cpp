// SPDX-License-Identifier: MIT
// Playback under a clock that is passed in: the frame for each time, exactly.
#include "edit/playback.hpp"

#include <gtest/gtest.h>

namespace vides {
namespace {

TEST(Playback, ShowsTheFrameOfEachTime) {
  Playback playback;
  playback.play(101);
  playback.advance(10.0, 101, 25.0);
  EXPECT_EQ(playback.frame(), 0);
  playback.advance(10.039, 101, 25.0);
  EXPECT_EQ(playback.frame(), 0);
  playback.advance(10.04, 101, 25.0);
  EXPECT_EQ(playback.frame(), 1);
  // Half a second without a picture: frames are dropped, time goes on.
  playback.advance(10.56, 101, 25.0);
  EXPECT_EQ(playback.frame(), 14);
  for (int n = 15; n < 100; ++n) {
    playback.advance(10.0 + n / 25.0, 101, 25.0);
    EXPECT_EQ(playback.frame(), n);
  }
  EXPECT_TRUE(playback.playing());
  playback.advance(99.0, 101, 25.0);
  EXPECT_EQ(playback.frame(), 100);
  EXPECT_FALSE(playback.playing());
}

TEST(Playback, LoopsWithoutLosingTime) {
  Playback playback;
  playback.setLoop(true);
  playback.play(10);
  playback.advance(0.0, 10, 10.0);
  playback.advance(2.35, 10, 10.0);
  EXPECT_EQ(playback.frame(), 3);
  EXPECT_TRUE(playback.playing());
  EXPECT_NEAR(*playback.nextFrameAt(10.0), 2.4, 1e-9);
}

TEST(Playback, GoesOnFromWhereThePlayheadIsPut) {
  Playback playback;
  playback.play(100);
  playback.advance(0.0, 100, 10.0);
  playback.advance(1.0, 100, 10.0);
  playback.goTo(50);
  playback.advance(1.5, 100, 10.0);
  EXPECT_EQ(playback.frame(), 50);
  playback.advance(2.0, 100, 10.0);
  EXPECT_EQ(playback.frame(), 55);
}

TEST(Playback, FromTheLastFrameItBeginsAgain) {
  Playback playback;
  playback.goTo(9);
  playback.play(10);
  EXPECT_EQ(playback.frame(), 0);
  EXPECT_FALSE(Playback().nextFrameAt(25.0));
}

TEST(Playback, AFlightOfOneFrameStops) {
  Playback playback;
  playback.play(1);
  playback.advance(0.0, 1, 25.0);
  EXPECT_EQ(playback.frame(), 0);
  EXPECT_FALSE(playback.playing());
}

}  // namespace
}  // namespace vides
