// SPDX-License-Identifier: MIT
// Sections, frame counts, holds and durations by hand values (2-flight-model, "Sections", "Speed").
#include <gtest/gtest.h>

#include "evaluate/evaluation.hpp"
#include "support/random_flight.hpp"

namespace vides {
namespace {

Key keyAt(double x, std::vector<Vec3> aims) {
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

const Vec3 kForward(0.0, 0.0, 1.0);
const Vec3 kLeft(1.0, 0.0, 0.0);

Flight twoKeys() {
  Flight flight;
  flight.keys = KeyList{keyAt(-0.5, {kForward}), keyAt(0.5, {kForward})};
  return flight;
}

template <class Change>
Flight withOrientation(Flight flight, OrientationPlace place, Change change) {
  Key key = flight.keys[place.key];
  change(key.orientations[place.orientation]);
  flight.keys.set(place.key, key);
  return flight;
}

TEST(Sections, MoveTakesRateTimesLength) {
  const Evaluation e(twoKeys());
  ASSERT_EQ(e.sectionCount(), 1);
  const Section s = e.section(0);
  EXPECT_EQ(s.kind, SectionKind::kMove);
  EXPECT_DOUBLE_EQ(s.length, 1.0);
  EXPECT_EQ(s.frames, 100);
  EXPECT_EQ(e.frameCount(), 101);
  EXPECT_EQ(e.frame(0).camera.viewReferencePoint, Vec3(-0.5, 0.0, 0.0));
  EXPECT_EQ(e.frame(100).camera.viewReferencePoint, Vec3(0.5, 0.0, 0.0));
  EXPECT_NEAR(e.frame(25).camera.viewReferencePoint.x, -0.25, 1e-12);
}

TEST(Sections, KindsInTheOrderOfTheRules) {
  Flight flight = twoKeys();
  Key key = keyAt(-0.5, {kForward, kLeft, kLeft, kLeft, kLeft});
  key.orientations[2].roll = 30.0;
  key.orientations[3].roll = 390.0;  // the same roll
  key.orientations[3].zoom = 61.5;
  key.orientations[4] = key.orientations[3];
  flight.keys.set(0, key);
  const Evaluation e(flight);
  ASSERT_EQ(e.sectionCount(), 4);
  EXPECT_EQ(e.section(0).kind, SectionKind::kPan);
  EXPECT_EQ(e.section(0).frames, 50);  // 45 degrees of half the angle
  EXPECT_NEAR(e.section(0).angle, 90.0, 1e-12);
  EXPECT_EQ(e.section(1).kind, SectionKind::kRoll);
  EXPECT_EQ(e.section(1).frames, 33);  // a third of 90 degrees
  EXPECT_EQ(e.section(2).kind, SectionKind::kZoom);
  EXPECT_EQ(e.section(2).frames, 50);  // half of 99
  EXPECT_EQ(e.section(3).kind, SectionKind::kMove);
  EXPECT_EQ(e.section(3).from, (OrientationPlace{0, 4}));
  EXPECT_EQ(e.section(3).to, (OrientationPlace{1, 0}));
  EXPECT_EQ(e.section(3).firstFrame, 133);
  EXPECT_FALSE(e.sectionFrom({0, 3}).has_value());
}

TEST(Sections, HoldsAreEntriesOfTheirOwn) {
  Flight flight = withOrientation(twoKeys(), {0, 0}, [](Orientation& o) { o.hold = 0.5; });
  flight = withOrientation(flight, {1, 0}, [](Orientation& o) { o.hold = 0.02; });
  const Evaluation e(flight);
  ASSERT_EQ(e.sectionCount(), 3);
  EXPECT_EQ(e.section(0).kind, SectionKind::kHold);
  EXPECT_EQ(e.section(0).frames, 13);  // 12.5 goes up
  EXPECT_EQ(e.section(0).from, e.section(0).to);
  EXPECT_EQ(e.section(1).firstFrame, 13);
  EXPECT_EQ(e.section(2).kind, SectionKind::kHold);
  EXPECT_EQ(e.section(2).frames, 1);  // 0.5 frames go up
  EXPECT_EQ(e.frameCount(), 13 + 100 + 1 + 1);
  EXPECT_EQ(e.frame(12).camera, e.frame(0).camera);
  EXPECT_EQ(e.frame(114).section, 2);
  EXPECT_EQ(e.frame(114).kind, SectionKind::kHold);
  EXPECT_EQ(e.frameOf({0, 0}), 0);
  EXPECT_EQ(e.frameOf({1, 0}), 113);
}

TEST(Sections, DurationOverridesTheRateAndGivesFramesToNothing) {
  Flight flight = withOrientation(twoKeys(), {0, 0}, [](Orientation& o) { o.duration = 2.0; });
  EXPECT_EQ(Evaluation(flight).frameCount(), 51);
  Key key = keyAt(-0.5, {kForward, kForward});
  key.orientations[0].duration = 1.0;
  flight.keys.set(0, key);
  const Evaluation e(flight);
  ASSERT_EQ(e.sectionCount(), 2);
  EXPECT_EQ(e.section(0).kind, SectionKind::kHold);
  EXPECT_EQ(e.section(0).frames, 25);
  EXPECT_EQ(e.section(0).to, (OrientationPlace{0, 1}));
}

TEST(Sections, WithoutFramesOneFrameRemains) {
  Flight flight;
  flight.keys = KeyList{keyAt(0.0, {kForward}), keyAt(0.0, {kForward})};
  for (const bool closed : {false, true}) {
    flight.closed = closed;
    const Evaluation e(flight);
    EXPECT_EQ(e.frameCount(), 1);
    EXPECT_EQ(e.sectionCount(), 0);
    const Frame frame = e.frame(0);
    EXPECT_EQ(frame.section, 0);
    EXPECT_EQ(frame.kind, SectionKind::kHold);
    EXPECT_EQ(frame.camera.viewPlaneNormal, kForward);
    FrameWalk walk(e);
    Frame walked;
    ASSERT_TRUE(walk.next(walked));
    EXPECT_EQ(walked, frame);
    EXPECT_FALSE(walk.next(walked));
  }
}

TEST(Sections, ClosedFlightLeadsBack) {
  Flight flight = twoKeys();
  flight.closed = true;
  const Evaluation e(flight);
  ASSERT_EQ(e.sectionCount(), 2);
  EXPECT_EQ(e.section(1).to, (OrientationPlace{0, 0}));
  EXPECT_EQ(e.frameCount(), e.section(0).frames + e.section(1).frames);
  EXPECT_EQ(e.next({1, 0}), (OrientationPlace{0, 0}));
  flight.closed = false;
  EXPECT_EQ(Evaluation(flight).next({1, 0}), (OrientationPlace{1, 0}));
}

TEST(Sections, SpeedKnowsTheNearestSectionsWithFrames) {
  Flight flight;
  flight.keys = KeyList{keyAt(-0.9, {kForward}), keyAt(0.0, {kForward, kForward, kForward}),
                        keyAt(0.9, {kForward})};
  flight = withOrientation(flight, {0, 0}, [](Orientation& o) { o.speed.fill(20.0); });
  flight = withOrientation(flight, {1, 2}, [](Orientation& o) { o.speed.fill(80.0); });
  const Evaluation e(flight);
  ASSERT_EQ(e.sectionCount(), 2);
  EXPECT_EQ(e.speedAfter({0, 0}), 80.0);
  EXPECT_EQ(e.speedBefore({1, 2}), 20.0);
  EXPECT_FALSE(e.speedBefore({0, 0}).has_value());
  EXPECT_FALSE(e.speedAfter({1, 2}).has_value());
}

// At a stop, or where another kind of section begins, the curve continues on its own: "constant"
// is constant up to the end.
TEST(Sections, SpeedGoesOnBetweenSectionsOfOneKindWithoutARest) {
  Flight flight;
  flight.keys = KeyList{keyAt(-0.9, {kForward}), keyAt(0.0, {kForward, kLeft}), keyAt(0.5, {kLeft}),
                        keyAt(0.9, {kLeft})};
  flight = withOrientation(flight, {0, 0}, [](Orientation& o) { o.speed.fill(20.0); });
  flight = withOrientation(flight, {1, 1}, [](Orientation& o) { o.speed.fill(80.0); });
  const Evaluation kinds(flight);  // a move, a pan, two moves
  ASSERT_EQ(kinds.sectionCount(), 4);
  for (const OrientationPlace place : {OrientationPlace{0, 0}, {1, 0}}) {
    EXPECT_FALSE(kinds.speedBefore(place).has_value());
    EXPECT_FALSE(kinds.speedAfter(place).has_value());
    EXPECT_EQ(kinds.speedCurve(place).slopes(), SpeedValues{});
  }
  EXPECT_EQ(kinds.speedAfter({1, 1}), 50.0);
  EXPECT_EQ(kinds.speedBefore({2, 0}), 80.0);

  const auto hold = [&](double seconds) {
    return Evaluation(withOrientation(flight, {2, 0}, [&](Orientation& o) { o.hold = seconds; }));
  };
  EXPECT_EQ(hold(0.0199).speedAfter({1, 1}), 50.0);  // less than half a frame is no rest
  EXPECT_FALSE(hold(0.02).speedAfter({1, 1}).has_value());
  EXPECT_FALSE(hold(0.02).speedBefore({2, 0}).has_value());
}

TEST(Sections, SpeedGoesOnOverTheSeamUnlessItRests) {
  Flight flight = twoKeys();
  flight.closed = true;
  flight = withOrientation(flight, {0, 0}, [](Orientation& o) { o.speed.fill(20.0); });
  EXPECT_EQ(Evaluation(flight).speedBefore({0, 0}), 50.0);
  EXPECT_EQ(Evaluation(flight).speedAfter({1, 0}), 20.0);
  flight = withOrientation(flight, {0, 0}, [](Orientation& o) { o.hold = 1.0; });
  EXPECT_FALSE(Evaluation(flight).speedBefore({0, 0}).has_value());
  EXPECT_FALSE(Evaluation(flight).speedAfter({1, 0}).has_value());
  EXPECT_EQ(Evaluation(flight).speedAfter({0, 0}), 50.0);
}

TEST(Sections, EveryFrameBelongsToItsSection) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    test::Random random(seed);
    const Evaluation e(test::randomFlight(random, {.nasty = seed % 2 == 0}));
    std::int64_t first = 0;
    double length = 0.0;
    for (std::int64_t i = 0; i < e.sectionCount(); ++i) {
      const Section s = e.section(i);
      ASSERT_EQ(s.index, i);
      ASSERT_EQ(s.firstFrame, first);
      ASSERT_GE(s.frames, 1);
      for (const std::int64_t n : {first, first + s.frames - 1}) {
        ASSERT_EQ(e.frame(n).section, i);
        ASSERT_EQ(e.frame(n).kind, s.kind);
        ASSERT_EQ(e.sectionAtFrame(n)->index, i);
      }
      first += s.frames;
      length += s.length;
    }
    const bool lastFrame = !e.flight().closed || first == 0;
    ASSERT_EQ(e.frameCount(), first + (lastFrame ? 1 : 0));
    ASSERT_NEAR(e.length(), length, 1e-12 * (1.0 + length));
  }
}

}  // namespace
}  // namespace vides
