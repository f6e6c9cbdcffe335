// SPDX-License-Identifier: MIT
// Playback under a clock that is passed in: the frame for each time, exactly.
#include "edit/playback.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(Playback, PlaysWhatLiesBetweenInAndOut) {
  Playback playback;
  playback.setIn(20);
  playback.setOut(29);
  playback.play(101);  // from outside: at its first frame
  playback.advance(0.0, 101, 10.0);
  EXPECT_EQ(playback.frame(), 20);
  playback.advance(0.85, 101, 10.0);
  EXPECT_EQ(playback.frame(), 28);
  playback.advance(5.0, 101, 10.0);
  EXPECT_EQ(playback.frame(), 29);
  EXPECT_FALSE(playback.playing());
  // Looped, ten frames come again and again, and no time is lost.
  playback.setLoop(true);
  playback.goTo(25);
  playback.play(101);
  playback.advance(0.0, 101, 10.0);
  for (int n = 0; n < 200; ++n) {
    playback.advance(n / 10.0, 101, 10.0);
    EXPECT_EQ(playback.frame(), 20 + (5 + n) % 10) << n;
  }
  // Put behind the range it plays to the flight's end, then the range.
  playback.goTo(98);
  playback.advance(30.0, 101, 10.0);
  playback.advance(30.2, 101, 10.0);
  EXPECT_EQ(playback.frame(), 100);
  playback.advance(30.3, 101, 10.0);
  EXPECT_EQ(playback.frame(), 20);
  // A flight that became shorter than the range keeps to its last frame.
  playback.advance(30.4, 15, 10.0);
  EXPECT_EQ(playback.span(15).first, 14);
  EXPECT_EQ(playback.frame(), 14);
}

TEST(Playback, APointOnTheWrongSideTakesTheOtherAway) {
  Playback playback;
  playback.setIn(30);
  playback.setOut(20);
  EXPECT_FALSE(playback.in());
  EXPECT_EQ(playback.span(101).first, 0);
  EXPECT_EQ(playback.span(101).last, 20);
  playback.setIn(40);
  EXPECT_FALSE(playback.out());
  playback.setOut(40);  // one frame is a range
  EXPECT_EQ(playback.span(101).first, 40);
  EXPECT_EQ(playback.span(101).last, 40);
}

TEST(Playback, SlowAndFast) {
  for (const double speed : {0.25, 0.5, 1.0, 2.0, 4.0}) {
    Playback playback;
    playback.setSpeed(speed);
    playback.play(1001);
    playback.advance(7.0, 1001, 25.0);
    playback.advance(9.0, 1001, 25.0);
    EXPECT_EQ(playback.frame(), static_cast<int>(50 * speed)) << speed;
    EXPECT_NEAR(*playback.nextFrameAt(25.0), 7.0 + (std::floor(50 * speed) + 1) / (25 * speed),
                1e-9);
  }
  // Changed while it plays it goes on from the frame that is shown.
  Playback playback;
  playback.play(1001);
  playback.advance(0.0, 1001, 10.0);
  playback.advance(2.0, 1001, 10.0);
  playback.setSpeed(4.0);
  playback.advance(2.0, 1001, 10.0);
  EXPECT_EQ(playback.frame(), 20);
  playback.advance(3.0, 1001, 10.0);
  EXPECT_EQ(playback.frame(), 60);
}

}  // namespace
}  // namespace vides
