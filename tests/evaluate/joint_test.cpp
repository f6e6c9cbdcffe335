// SPDX-License-Identifier: MIT
// Jumps and stops at joints, against the frames on both sides; values that match.
#include "evaluate/joint.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_flight.hpp"

namespace vides {
namespace {

using Meeting = Joint::Meeting;

Key keyAt(double x, const std::vector<Vec3>& aims = {{0.0, 0.0, 1.0}}) {
  Key key;
  key.position = {x, 0.0, 0.0};
  key.orientations.clear();
  for (const Vec3& aim : aims) {
    Orientation o;
    o.aimMode = AimMode::kRelative;
    o.aim = aim;
    key.orientations.push_back(o);
  }
  return key;
}

template <class Change>
Flight with(Flight flight, OrientationPlace place, Change change) {
  Key key = flight.keys[place.key];
  change(key.orientations[place.orientation]);
  flight.keys.set(place.key, key);
  return flight;
}

// Three moves of 100 frames each, along a line.
Flight threeMoves() {
  Flight flight;
  flight.rates.move = 200.0;
  flight.keys = KeyList{keyAt(-0.75), keyAt(-0.25), keyAt(0.25), keyAt(0.75)};
  return flight;
}

double speedAt(const Evaluation& e, std::int64_t frame) {
  return glm::length(e.frame(frame + 1).camera.viewReferencePoint -
                     e.frame(frame).camera.viewReferencePoint);
}

TEST(Joints, AFlightsEndsAreNone) {
  const Evaluation e(threeMoves());
  const Joint first = jointAt(e, {0, 0}, SectionEnd::kStart);
  EXPECT_EQ(first.meeting, Meeting::kNothing);
  EXPECT_FALSE(first.value);
  EXPECT_EQ(jointAt(e, {2, 0}, SectionEnd::kEnd).meeting, Meeting::kNothing);
  EXPECT_EQ(jointAt(e, {3, 0}, SectionEnd::kEnd).meeting, Meeting::kNothing);  // no section
  // A hold there is a stop.
  const Evaluation held(with(threeMoves(), {0, 0}, [](Orientation& o) { o.hold = 1.0; }));
  EXPECT_EQ(jointAt(held, {0, 0}, SectionEnd::kStart).meeting, Meeting::kRests);
  EXPECT_EQ(jointAt(held, {0, 0}, SectionEnd::kStart).change, 1.0);
}

TEST(Joints, EqualValuesByRateAreNoJump) {
  const Evaluation e(threeMoves());
  for (const SectionEnd end : {SectionEnd::kStart, SectionEnd::kEnd}) {
    const Joint joint = jointAt(e, {1, 0}, end);
    EXPECT_EQ(joint.meeting, Meeting::kGoesOn);
    EXPECT_EQ(joint.value, 50.0);
    EXPECT_EQ(joint.asFast, 50.0);
    EXPECT_FALSE(joint.jumps);
    EXPECT_NEAR(joint.change, 0.0, 1e-9);
  }
}

TEST(Joints, OtherValuesByRateAreAJump) {
  const Evaluation e(with(threeMoves(), {1, 0}, [](Orientation& o) { o.speed.fill(80.0); }));
  const Joint joint = jointAt(e, {0, 0}, SectionEnd::kEnd);
  EXPECT_TRUE(joint.jumps);
  EXPECT_EQ(joint.value, 80.0);
  EXPECT_EQ(joint.asFast, 80.0);
  const std::int64_t n = e.section(1).firstFrame;
  EXPECT_NEAR(joint.change, 1.0 - speedAt(e, n - 1) / speedAt(e, n), 1e-9);
  EXPECT_EQ(*matchingSpeed(e, {0, 0}, SectionEnd::kEnd), 80.0);
}

// The same values, but one section takes twice its time: half as fast.
TEST(Joints, DurationsCount) {
  const Flight flight = with(threeMoves(), {1, 0}, [](Orientation& o) { o.duration = 8.0; });
  const Evaluation e(flight);
  const Joint joint = jointAt(e, {0, 0}, SectionEnd::kEnd);
  EXPECT_TRUE(joint.jumps);
  EXPECT_EQ(joint.value, 50.0);
  EXPECT_NEAR(joint.asFast, 25.0, 1e-9);
  EXPECT_NEAR(joint.change, 0.5, 1e-9);
  EXPECT_NEAR(jointAt(e, {1, 0}, SectionEnd::kStart).asFast, 100.0, 1e-9);
  // And values that differ may be as fast: half of it, by what the curves' means change.
  const double value = *matchingSpeed(e, {0, 0}, SectionEnd::kEnd);
  EXPECT_NEAR(value, 25.0, 0.1);
  const Evaluation same(with(flight, {0, 0}, [&](Orientation& o) { o.speed.back() = value; }));
  EXPECT_FALSE(jointAt(same, {0, 0}, SectionEnd::kEnd).jumps);
}

TEST(Joints, RestsAndOtherKindsAreStops) {
  Flight flight = threeMoves();
  flight.keys.set(1, keyAt(-0.25, {{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}}));
  flight = with(flight, {2, 0}, [](Orientation& o) {
    o.aim = {1.0, 0.0, 0.0};
    o.hold = 0.5;
  });
  flight = with(flight, {3, 0}, [](Orientation& o) { o.aim = {1.0, 0.0, 0.0}; });
  const Evaluation e(flight);  // a move, a pan, a move, a hold, a move
  const Joint toPan = jointAt(e, {0, 0}, SectionEnd::kEnd);
  EXPECT_EQ(toPan.meeting, Meeting::kOtherKind);
  EXPECT_TRUE(toPan.stops());
  EXPECT_FALSE(toPan.jumps);
  EXPECT_EQ(toPan.value, 50.0);
  EXPECT_NEAR(toPan.change, 1.0, 1e-9);
  EXPECT_EQ(jointAt(e, {1, 0}, SectionEnd::kStart).meeting, Meeting::kOtherKind);
  EXPECT_EQ(jointAt(e, {1, 1}, SectionEnd::kStart).meeting, Meeting::kOtherKind);
  EXPECT_EQ(jointAt(e, {1, 1}, SectionEnd::kEnd).meeting, Meeting::kRests);
  EXPECT_EQ(jointAt(e, {2, 0}, SectionEnd::kStart).meeting, Meeting::kRests);
  EXPECT_FALSE(matchingSpeed(e, {1, 1}, SectionEnd::kEnd));
  EXPECT_FALSE(matchingSpeed(e, {0, 0}, SectionEnd::kEnd));
}

// A section in which nothing differs, of its own duration, is a hold, too.
TEST(Joints, AHoldWithADurationIsARest) {
  Flight flight = threeMoves();
  flight.keys.set(1, keyAt(-0.25, {{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}}));
  flight = with(flight, {1, 0}, [](Orientation& o) { o.duration = 1.0; });
  const Evaluation e(flight);
  EXPECT_EQ(jointAt(e, {0, 0}, SectionEnd::kEnd).meeting, Meeting::kRests);
  EXPECT_EQ(jointAt(e, {1, 1}, SectionEnd::kStart).meeting, Meeting::kRests);
  // It moves nothing itself.
  EXPECT_EQ(jointAt(e, {1, 0}, SectionEnd::kStart).meeting, Meeting::kNothing);
}

TEST(Joints, GoOverTheSeam) {
  Flight flight = threeMoves();
  flight.closed = true;
  flight = with(flight, {0, 0}, [](Orientation& o) { o.speed.fill(20.0); });
  const Evaluation e(flight);
  const Joint joint = jointAt(e, {3, 0}, SectionEnd::kEnd);
  EXPECT_EQ(joint.meeting, Meeting::kGoesOn);
  EXPECT_EQ(joint.value, 20.0);
  EXPECT_TRUE(joint.jumps);
  const double before = glm::length(e.frame(0).camera.viewReferencePoint -
                                    e.frame(e.frameCount() - 1).camera.viewReferencePoint);
  EXPECT_NEAR(joint.change, 1.0 - speedAt(e, 0) / before, 1e-9);
  EXPECT_EQ(jointAt(e, {0, 0}, SectionEnd::kStart).change, joint.change);
}

// Whatever lies beside: afterwards the speeds are equal, as far as whole frames allow it.
TEST(Joints, MatchingMakesRealSpeedsEqual) {
  int matched = 0, refused = 0;
  for (std::uint64_t seed = 1; matched < 200; ++seed) {
    test::Random random(seed);
    Flight flight = test::randomFlight(random, {.mostKeys = 6});
    const Evaluation e(flight);
    for (std::int64_t i = 0; i < e.sectionCount(); ++i) {
      const Section s = e.section(i);
      const SectionEnd end = test::chance(random, 0.5) ? SectionEnd::kStart : SectionEnd::kEnd;
      const Joint joint = jointAt(e, s.from, end);
      if (joint.meeting != Meeting::kGoesOn || s.from == s.to) continue;
      const auto value = matchingSpeed(e, s.from, end);
      if (!value) {
        ++refused;
        continue;
      }
      ASSERT_GE(*value, 1.0);
      ASSERT_LE(*value, 100.0);
      const Evaluation now(with(flight, s.from, [&](Orientation& o) {
        (end == SectionEnd::kStart ? o.speed.front() : o.speed.back()) = *value;
      }));
      const Joint after = jointAt(now, s.from, end);
      ASSERT_FALSE(after.jumps) << "seed " << seed << " section " << i;
      ASSERT_NEAR(after.asFast, *value, 2e-6 * *value);
      ++matched;
    }
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace vides
