// SPDX-License-Identifier: MIT
// What is given in seconds is rounded together (2-flight-model, "Frames"): hand values, and random
// flights against sums that run along the whole film.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "evaluate/evaluation.hpp"
#include "evaluate/frame_sum.hpp"
#include "support/random_flight.hpp"

namespace vides {
namespace {

using test::Random;

struct Times {
  double hold = 0.0;  // seconds
  std::optional<double> duration;
};

// Keys in a row at the distance of `step`, which take 100 frames a cube unit where not timed.
Flight rowOf(const std::vector<Times>& times, double frameRate = 25.0) {
  Flight flight;
  flight.frameRate = frameRate;
  std::vector<KeyPointer> keys;
  for (std::size_t k = 0; k < times.size(); ++k) {
    Key key;
    key.position = {-0.9 + 0.01 * static_cast<double>(k), 0.0, 0.0};
    key.orientations[0].aimMode = AimMode::kRelative;
    key.orientations[0].aim = {0.0, 0.0, 1.0};
    key.orientations[0].hold = times[k].hold;
    key.orientations[0].duration = times[k].duration;
    keys.emplace_back(key);
  }
  flight.keys = KeyList(std::move(keys));
  return flight;
}

std::vector<std::int64_t> framesOf(const Evaluation& e) {
  std::vector<std::int64_t> frames;
  for (std::int64_t i = 0; i < e.sectionCount(); ++i) frames.push_back(e.section(i).frames);
  return frames;
}

using Counts = std::vector<std::int64_t>;

// 3/11 s at 24 frames a second are 6.545 frames; rounded one by one 100 of them were 700.
TEST(Frames, ABeatDoesNotDrift) {
  std::vector<Times> times(101, Times{0.0, 3.0 / 11.0});
  const Evaluation e(rowOf(times, 24.0));
  EXPECT_EQ(e.frameCount(), 655 + 1);
  EXPECT_EQ(e.section(0).frames, 7);
  EXPECT_EQ(e.section(1).frames, 6);
  for (std::int64_t i = 0; i < 100; ++i) {
    const double exact = static_cast<double>(i) * 72.0 / 11.0;
    EXPECT_LE(std::abs(static_cast<double>(e.section(i).firstFrame) - exact), 0.5) << i;
  }
}

TEST(Frames, HoldsAndDurationsAreOneStretch) {
  // 2.5, 3.5, 1.25, 1.25 and 1.5 frames end at 2.5, 6, 7.25, 8.5 and 10.
  const Evaluation e(rowOf({{0.1, 0.14}, {0.05, 0.05}, {0.06, {}}}));
  EXPECT_EQ(framesOf(e), (Counts{3, 3, 1, 2, 1}));
}

TEST(Frames, ASectionByRateEndsTheStretch) {
  // 2.5 and 2.5 frames, each alone; together they would be 3 and 2.
  const Evaluation e(rowOf({{0.0, 0.1}, {0.0, {}}, {0.0, 0.1}, {}}));
  EXPECT_EQ(framesOf(e), (Counts{3, 1, 3}));
  EXPECT_EQ(framesOf(Evaluation(rowOf({{0.0, 0.1}, {0.0, 0.1}, {0.0, {}}, {}}))),
            (Counts{3, 2, 1}));
}

// What has no frames, a section in which nothing differs or a hold of less than half a frame, is
// not there.
TEST(Frames, WhatHasNoFramesEndsNoStretch) {
  Flight flight = rowOf({{0.0, 0.1}, {0.0196, 0.1}, {}});
  Key key = flight.keys[1];
  key.orientations.insert(key.orientations.begin(), 2, key.orientations[0]);
  for (Orientation& o : key.orientations) o.duration.reset();
  key.orientations.back().duration = 0.1;
  flight.keys.set(1, key);
  EXPECT_EQ(framesOf(Evaluation(flight)), (Counts{3, 2}));
}

TEST(Frames, ASeamBeginsAnew) {
  Flight flight = rowOf({{0.0, 0.1}, {0.0, 0.1}, {0.0, 0.1}});
  flight.closed = true;
  EXPECT_EQ(framesOf(Evaluation(flight)), (Counts{3, 2, 3}));
}

// Durations of less count as one frame, holds of half a frame to one get what the stretch leaves.
TEST(Frames, ShortHoldsMayVanish) {
  Flight flight = rowOf({{0.02, 0.01}, {0.02, 0.04}, {0.02, 0.04}, {}});
  const Evaluation e(flight);
  // They end at 0.5, 1.5, 2, 3, 3.5, 4.5.
  EXPECT_EQ(framesOf(e), (Counts{1, 1, 1, 1, 1}));
  ASSERT_EQ(e.sectionCount(), 5);
  EXPECT_EQ(e.section(2).kind, SectionKind::kMove);  // the hold between is left out
  EXPECT_EQ(e.section(2).from, (OrientationPlace{1, 0}));
  EXPECT_EQ(e.section(3).kind, SectionKind::kHold);
  EXPECT_EQ(e.section(3).from, (OrientationPlace{2, 0}));
  EXPECT_EQ(e.frameCount(), 6);
  // The joint rests all the same: its curve doesn't go on.
  EXPECT_FALSE(e.speedBefore({1, 0}).has_value());
  EXPECT_EQ(e.frame(2).section, 2);
  EXPECT_EQ(e.frameOf({1, 0}), 2);
}

TEST(Frames, AHoldAtTheEndMayVanish) {
  const Evaluation e(rowOf({{0.0, 0.1}, {0.03, {}}}));  // 2.5 and 0.75: end at 3 and 3
  EXPECT_EQ(framesOf(e), (Counts{3}));
  EXPECT_EQ(e.frameCount(), 4);
  EXPECT_EQ(e.frame(3).kind, SectionKind::kMove);
  EXPECT_EQ(e.frame(3).section, 0);
}

TEST(Frames, HugeTimesDoNotOverflow) {
  Flight flight = rowOf(std::vector<Times>(300, Times{86'400.0, 86'400.0}), 1000.0);
  EXPECT_EQ(Evaluation(flight).frameCount(), 599 * std::int64_t{86'400'000} + 1);
}

// The rule as it is written, from one end of the film to the other.
class Stretch {
 public:
  std::int64_t add(double frames) {
    sum_ += static_cast<std::int64_t>(std::floor(frames * 16'777'216.0 + 0.5));
    const std::int64_t end = (sum_ * 2 + 16'777'216) / (2 * 16'777'216);
    const std::int64_t count = end - end_;
    end_ = end;
    return count;
  }
  void end() { *this = Stretch(); }

 private:
  std::int64_t sum_ = 0;
  std::int64_t end_ = 0;
};

void expectTheRule(const Evaluation& e) {
  const Flight& flight = e.flight();
  Stretch stretch;
  std::int64_t frame = 0;
  std::int64_t index = 0;
  const auto expectNext = [&](const OrientationPlace& place, bool hold, std::int64_t frames) {
    const Section s = e.section(index);
    ASSERT_EQ(s.index, index);
    ASSERT_EQ(s.from, place);
    ASSERT_EQ(s.from == s.to, hold);
    ASSERT_EQ(s.frames, frames);
    ASSERT_EQ(s.firstFrame, frame);
    for (const std::int64_t n : {frame, frame + frames - 1}) {
      ASSERT_EQ(e.frame(n).section, index);
      ASSERT_EQ(e.sectionAtFrame(n)->index, index);
    }
    frame += frames;
    ++index;
  };
  for (std::size_t k = 0; k < flight.keys.size(); ++k) {
    const Key& key = flight.keys[k];
    for (std::size_t j = 0; j < key.orientations.size(); ++j) {
      const Orientation& o = key.orientations[j];
      ASSERT_EQ(e.frameOf({k, j}), std::min(frame, e.frameCount() - 1));
      const double hold = o.hold * flight.frameRate;
      if (std::floor(hold + 0.5 + 1e-9) >= 1.0) {
        const std::int64_t frames = stretch.add(hold);
        if (frames > 0) expectNext({k, j}, true, frames);
      }
      const auto section = e.sectionFrom({k, j});
      if (!section) continue;
      if (o.duration) {
        expectNext({k, j}, false, stretch.add(std::max(1.0, *o.duration * flight.frameRate)));
      } else {
        stretch.end();
        expectNext({k, j}, false, section->frames);
      }
    }
  }
  ASSERT_EQ(e.sectionCount(), index);
  ASSERT_EQ(e.frameCount(), flight.closed && frame > 0 ? frame : frame + 1);
}

TEST(Frames, FollowTheRuleInRandomFlights) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Flight flight =
        test::randomFlight(random, {.nasty = seed % 3 == 0, .mostKeys = 40, .timed = true});
    if (seed % 40 == 0) {
      while (flight.keys.size() < 1500) {
        Key key = test::randomKey(random, false);
        test::timeRandomly(random, flight.frameRate, key);
        flight.keys.push_back(std::move(key));
      }
    }
    expectTheRule(Evaluation(flight));
    if (HasFatalFailure()) return;
  }
}

FrameSum anySum(Random& random) {
  return test::chance(random, 0.3) ? FrameSum::byRate(test::integer(random, 1, 3))
                                   : FrameSum::timed(test::integer(random, 0, 3 << 23));
}

TEST(FrameSum, IsAssociativeAndItsSlackBounds) {
  Random random(3);
  for (int i = 0; i < 20'000; ++i) {
    FrameSum a, b, c;
    for (int n = test::integer(random, 0, 3); n > 0; --n) a = a + anySum(random);
    for (int n = test::integer(random, 0, 3); n > 0; --n) b = b + anySum(random);
    for (int n = test::integer(random, 0, 3); n > 0; --n) c = c + anySum(random);
    ASSERT_EQ((a + b) + c, a + (b + c));
    const std::int64_t apart = (a + b).frames() - a.frames() - b.frames();
    ASSERT_LE(std::abs(apart), a.addsUp() ? 0 : FrameSum::kSlack);
    ASSERT_GE((a + b).frames(), a.frames());
  }
}

}  // namespace
}  // namespace vides
