// SPDX-License-Identifier: MIT
// Dividing a section at a frame keeps the film (2-flight-model and 5-editor, "insert at the
// playhead").
#include "evaluate/division.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "flight/validation.hpp"
#include "support/random_flight.hpp"

namespace vides {
namespace {

using test::Random;

const Orientation& at(const Flight& flight, const OrientationPlace& place) {
  return flight.keys[place.key].orientations[place.orientation];
}

double apart(const Camera& a, const Camera& b) {
  return std::max({glm::length(a.viewReferencePoint - b.viewReferencePoint),
                   glm::length(a.viewPlaneNormal - b.viewPlaneNormal),
                   glm::length(a.viewUpVector - b.viewUpVector), std::abs(a.zoom - b.zoom)});
}

// --- Over random flights ---

// A speed curve as a hand draws a smooth one.
SpeedValues smoothSpeeds(Random& random) {
  SpeedValues values;
  values.fill(50.0);
  if (test::chance(random, 0.3)) return values;
  const double middle = random.between(20.0, 80.0);
  const double most = std::min(middle - 2.0, 99.0 - middle);
  const double a = random.between(-0.5, 0.5) * most, b = random.between(-0.5, 0.5) * most;
  const double turns = random.between(0.0, 1.0), phase = random.between(0.0, 6.3);
  for (std::size_t j = 0; j < values.size(); ++j) {
    const double t = static_cast<double>(j) / 9.0;
    values[j] =
        middle + a * std::sin(2.0 * std::numbers::pi * turns * t + phase) + b * (2.0 * t - 1.0);
  }
  return values;
}

Flight smoothFlight(Random& random, const test::FlightKind& kind) {
  Flight flight = test::randomFlight(random, kind);
  flight.rates.move = random.between(5.0, 100.0);
  for (std::size_t k = 0; k < flight.keys.size(); ++k) {
    Key key = flight.keys[k];
    for (Orientation& o : key.orientations) o.speed = smoothSpeeds(random);
    flight.keys.set(k, key);
  }
  return flight;
}

// A speed curve is smooth also where its neighbours go on as it ends.
bool joinsSmoothly(const Evaluation& e, const OrientationPlace& place) {
  const SpeedValues& v = e.speedCurve(place).values();
  return std::abs(e.speedBefore(place).value_or(v.front()) - v.front()) < 20.0 &&
         std::abs(e.speedAfter(place).value_or(v.back()) - v.back()) < 20.0;
}

// The largest difference of the shares of the section's way, over its frames.
double shareError(const Evaluation& before, const Section& section, const Evaluation& after,
                  const OrientationPlace& place, std::int64_t cut) {
  const auto share = [](const Evaluation& e, const OrientationPlace& from, std::int64_t j,
                        std::int64_t frames) {
    return e.speedCurve(from).progress(static_cast<double>(j) / static_cast<double>(frames));
  };
  const double first = share(before, section.from, cut, section.frames);
  double most = 0.0;
  for (std::int64_t j = 0; j < section.frames; ++j) {
    const double is =
        j < cut ? first * share(after, section.from, j, cut)
                : first + (1.0 - first) * share(after, place, j - cut, section.frames - cut);
    most = std::max(most, std::abs(is - share(before, section.from, j, section.frames)));
  }
  return most;
}

// All other sections and holds are on the frames on which they were.
void expectOthersStay(const Evaluation& before, const Section& divided, const Evaluation& after) {
  // Both halves of less than two frames count as whole frames: the next parts of a timed stretch
  // give way, and a hold of half a frame among them may get one.
  const Flight& flight = before.flight();
  const auto duration = at(flight, divided.from).duration;
  if (duration && *duration * flight.frameRate < 2.0) return;
  ASSERT_EQ(after.sectionCount(), before.sectionCount() + 1);
  for (std::int64_t i = 0; i < before.sectionCount(); ++i) {
    if (i == divided.index) continue;
    const Section was = before.section(i);
    const Section is = after.section(i < divided.index ? i : i + 1);
    ASSERT_EQ(is.firstFrame, was.firstFrame);
    ASSERT_EQ(is.frames, was.frames);
    ASSERT_EQ(is.kind, was.kind);
  }
}

struct Counts {
  int divided = 0, byRate = 0, leftRate = 0, smooth = 0;
};

void divideRandomly(std::uint64_t seed, const test::FlightKind& kind, Counts& counts) {
  Random random(seed);
  const Flight flight = smoothFlight(random, kind);
  const Evaluation before(flight);
  const auto n =
      static_cast<std::int64_t>(random.unit() * static_cast<double>(before.frameCount()));
  const auto division = divideAtFrame(before, n);
  const auto section = before.sectionAtFrame(n);
  if (!division) {
    // Nothing but what is said may stand in the way.
    if (division.error() == DivisionRefusal::kSectionBegins) {
      ASSERT_EQ(section->firstFrame, n);
    } else if (division.error() == DivisionRefusal::kFlightEnds) {
      ASSERT_EQ(n, before.frameCount() - 1);
    } else if (division.error() == DivisionRefusal::kTooManyOrientations) {
      ASSERT_EQ(flight.keys[section->from.key].orientations.size(), kMostOrientations);
    } else if (division.error() == DivisionRefusal::kOutsideCube) {
      const Vec3 p = glm::abs(before.frame(n).camera.viewReferencePoint);
      ASSERT_GT(std::max({p.x, p.y, p.z}), 1.0);
    } else {
      ASSERT_EQ(division.error(), DivisionRefusal::kNothingHappens);
      ASSERT_FALSE(section);
    }
    return;
  }
  ++counts.divided;
  ASSERT_TRUE(validate(division->flight).empty());
  const Evaluation after(division->flight);
  const std::int64_t cut = n - section->firstFrame;
  ASSERT_EQ(after.frameCount(), before.frameCount());
  ASSERT_EQ(after.frameOf(division->place), n);
  ASSERT_NO_FATAL_FAILURE(expectOthersStay(before, *section, after));
  const Camera camera = before.frame(n).camera;
  // Closer than 1e-7 to a pole an aim doesn't tell the yaw.
  if (std::hypot(camera.viewPlaneNormal.x, camera.viewPlaneNormal.z) > 1e-6) {
    // In a hold between keys that are one place, the place may creep a little.
    const double same = section->kind == SectionKind::kHold ? 1e-8 : 1e-9;
    ASSERT_LT(apart(after.frame(n).camera, camera), same);
    ASSERT_LT(apart(after.cameraAt(division->place), camera), same);
  }
  if (section->from == section->to || section->kind == SectionKind::kHold) return;
  if (!at(flight, section->from).duration) {
    const bool stays = !at(division->flight, section->from).duration;
    ASSERT_EQ(stays, !at(division->flight, division->place).duration);
    ++(stays ? counts.byRate : counts.leftRate);
  }
  if (!joinsSmoothly(before, section->from)) return;
  ++counts.smooth;
  ASSERT_LT(shareError(before, *section, after, division->place, cut), 1e-3);
}

TEST(Division, KeepsTheFilmOfRandomFlights) {
  const test::FlightKind kinds[] = {{.mostKeys = 6},
                                    {.mostKeys = 3},
                                    {.nasty = true},
                                    {.timed = true},
                                    {.nasty = true, .timed = true}};
  Counts counts;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    divideRandomly(seed, kinds[seed % std::size(kinds)], counts);
    if (testing::Test::HasFatalFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(counts.divided, 1500);
  EXPECT_GT(counts.smooth, 700);
  // Most sections by rate stay so, although random curves bend much.
  EXPECT_GT(counts.byRate, 4 * counts.leftRate);
}

// A place on the curve: the key comes there, the next frame hits it.
TEST(Division, AtAPlaceTheKeyIsThere) {
  int divided = 0;
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    Random random(seed);
    const Flight flight = smoothFlight(random, {.mostKeys = 5, .timed = seed % 3 == 0});
    const Evaluation before(flight);
    const auto piece = static_cast<std::size_t>(
        test::integer(random, 0, static_cast<int>(before.pieceCount()) - 1));
    const double fraction = random.unit();
    const auto division = divideAtPlace(before, piece, fraction);
    if (!division) continue;
    ++divided;
    const Evaluation after(division->flight);
    ASSERT_EQ(division->place, (OrientationPlace{piece + 1, 0}));
    ASSERT_LT(
        glm::length(division->flight.keys[piece + 1].position - before.piecePoint(piece, fraction)),
        1e-9)
        << seed;
    const Section section =
        *before.sectionFrom({piece, flight.keys[piece].orientations.size() - 1});
    ASSERT_EQ(after.frameCount(), before.frameCount()) << seed;
    ASSERT_NO_FATAL_FAILURE(expectOthersStay(before, section, after)) << seed;
    // Before and after it the camera has not come as far, or farther.
    const std::int64_t cut = after.frameOf(division->place) - section.firstFrame;
    const auto share = [&](double j) {
      return before.speedCurve(section.from).progress(j / static_cast<double>(section.frames));
    };
    const double half = 0.5 + 1e-6;
    if (cut > 1) {
      ASSERT_LT(share(static_cast<double>(cut) - half), fraction) << seed;
    }
    if (cut < section.frames - 1) {
      ASSERT_GT(share(static_cast<double>(cut) + half), fraction) << seed;
    }
  }
  EXPECT_GT(divided, 250);
}

// --- What is inserted ---

Flight withFirst(Flight flight, auto change) {
  Key key = flight.keys[0];
  change(key);
  flight.keys.set(0, key);
  return flight;
}

TEST(Division, OfAStraightMoveKeepsRoundNumbers) {
  const Evaluation before(newFlight());  // a cube unit long, 100 frames
  const auto division = divideAtFrame(before, 25);
  ASSERT_TRUE(division);
  const Key& key = division->flight.keys[1];
  EXPECT_NEAR(key.position.x, -0.25, 1e-12);
  EXPECT_EQ(key.shape.preset, 0);
  ASSERT_EQ(key.orientations.size(), 1u);
  EXPECT_EQ(key.orientations[0].aim, Vec3(0.0));
  EXPECT_EQ(key.orientations[0].roll, 0.0);
  EXPECT_EQ(key.orientations[0].speed, newFlight().keys[0].orientations[0].speed);
  EXPECT_EQ(division->flight.keys[0], newFlight().keys[0]);
  EXPECT_EQ(division->flight.keys[2], newFlight().keys[1]);
  const Evaluation after(division->flight);
  EXPECT_EQ(after.section(0).frames, 25);
  EXPECT_EQ(after.section(1).frames, 75);
}

TEST(Division, OfASlopeEndsAsItDidAndMeetsInTheMiddle) {
  const Flight flight = withFirst(newFlight(), [](Key& key) {
    for (std::size_t j = 0; j < 10; ++j) {
      key.orientations[0].speed[j] = 10.0 + 9.0 * static_cast<double>(j);
    }
  });
  const Evaluation before(flight);
  const std::int64_t cut = before.frameCount() / 3;
  const auto division = divideAtFrame(before, cut);
  ASSERT_TRUE(division);
  const Evaluation after(division->flight);
  EXPECT_LT(shareError(before, before.section(0), after, {1, 0}, cut), 5e-4);
  EXPECT_NEAR(after.speedCurve({0, 0}).values().front(), 10.0, 1.0);
  EXPECT_NEAR(after.speedCurve({0, 0}).values().back(), 37.0, 2.0);
  EXPECT_NEAR(after.speedCurve({1, 0}).values().front(), 37.0, 2.0);
  EXPECT_NEAR(after.speedCurve({1, 0}).values().back(), 91.0, 1.0);
}

TEST(Division, KeepsAbsoluteAimsWhereTheCameraTracksAndTheDistanceElsewhere) {
  Flight flight = withFirst(newFlight(), [](Key& key) {
    key.orientations[0].aim = {0.2, -0.4, 0.1};
  });
  Key last = flight.keys[1];
  last.orientations[0].aim = {0.2, -0.4, 0.1};
  flight.keys.set(1, last);
  const auto tracked = divideAtFrame(Evaluation(flight), 40);
  ASSERT_TRUE(tracked);
  EXPECT_EQ(tracked->flight.keys[1].orientations[0].aim, Vec3(0.2, -0.4, 0.1));
  // Slerp doesn't track.
  flight.orientationCurve = OrientationCurve::kSlerp;
  const auto seen = divideAtFrame(Evaluation(flight), 40);
  ASSERT_TRUE(seen);
  const Key& key = seen->flight.keys[1];
  EXPECT_EQ(key.orientations[0].aimMode, AimMode::kAbsolute);
  EXPECT_NE(key.orientations[0].aim, Vec3(0.2, -0.4, 0.1));
  EXPECT_NEAR(glm::length(aimOffset(key, key.orientations[0])),
              glm::length(aimOffset(flight.keys[0], flight.keys[0].orientations[0])), 1e-9);
  // A relative one stays relative, and far or near.
  for (const double far : {1e-7, 0.3, 9e5}) {
    const Flight relative = withFirst(newFlight(), [&](Key& k) {
      k.orientations[0].aimMode = AimMode::kRelative;
      k.orientations[0].aim = far * glm::normalize(Vec3(0.3, -0.2, -0.5));
    });
    const Evaluation before(relative);
    const auto divided = divideAtFrame(before, 40);
    ASSERT_TRUE(divided);
    const Orientation& o = divided->flight.keys[1].orientations[0];
    EXPECT_EQ(o.aimMode, AimMode::kRelative);
    EXPECT_NEAR(glm::length(o.aim) / far, 1.0, 1e-9);
    EXPECT_LT(apart(Evaluation(divided->flight).frame(40).camera, before.frame(40).camera), 1e-9);
  }
}

// A pan, a roll and a zoom at one key, a hold of one second before the first of them. With slerp
// nothing but the roll turns in the roll.
Flight atOneKey() {
  Flight flight = newFlight();
  flight.orientationCurve = OrientationCurve::kSlerp;
  return withFirst(flight, [](Key& key) {
    Orientation o = key.orientations[0];
    key.orientations[0].hold = 1.0;
    o.aim = {0.5, 0.1, -0.5};
    key.orientations.push_back(o);
    o.roll = 50.0;
    key.orientations.push_back(o);
    o.zoom = 80.0;
    key.orientations.push_back(o);
  });
}

TEST(Division, OfATurnAddsAnOrientationAtTheSameKey) {
  const Evaluation before(atOneKey());
  const SectionKind kinds[] = {SectionKind::kHold, SectionKind::kPan, SectionKind::kRoll,
                               SectionKind::kZoom};
  for (std::int64_t i = 1; i < 4; ++i) {
    const Section section = before.section(i);
    ASSERT_EQ(section.kind, kinds[i]);
    const std::int64_t n = section.firstFrame + section.frames / 3;
    const auto division = divideAtFrame(before, n);
    ASSERT_TRUE(division) << i;
    EXPECT_EQ(division->flight.keys.size(), 2u);
    EXPECT_EQ(division->place, (OrientationPlace{0, section.from.orientation + 1}));
    const Evaluation after(division->flight);
    EXPECT_EQ(after.section(i).kind, section.kind);
    EXPECT_EQ(after.section(i + 1).kind, section.kind);
    EXPECT_EQ(after.section(i).frames, section.frames / 3);
    EXPECT_FALSE(at(division->flight, division->place).duration);
    EXPECT_EQ(at(division->flight, division->place).hold, 0.0);
    EXPECT_LT(apart(after.frame(n).camera, before.frame(n).camera), 1e-9);
    if (i == 2) {
      EXPECT_EQ(at(division->flight, division->place).aim, Vec3(0.5, 0.1, -0.5));
    }
    if (i == 3) {
      EXPECT_EQ(at(division->flight, division->place).roll, 50.0);
    }
  }
}

TEST(Division, OfAHoldDividesIt) {
  const Evaluation before(atOneKey());
  const auto division = divideAtFrame(before, 10);
  ASSERT_TRUE(division);
  const Key& key = division->flight.keys[0];
  ASSERT_EQ(key.orientations.size(), 5u);
  EXPECT_EQ(key.orientations[0].hold, 0.4);
  EXPECT_NEAR(key.orientations[1].hold, 0.6, 1e-15);
  EXPECT_EQ(key.orientations[1].aim, key.orientations[0].aim);
  const Evaluation after(division->flight);
  EXPECT_EQ(after.frameCount(), before.frameCount());
  EXPECT_EQ(after.frameOf({0, 1}), 10);
  // A hold that comes from a duration gets two.
  const Flight still = withFirst(atOneKey(), [](Key& k) {
    k.orientations[1] = k.orientations[0];
    k.orientations[0].duration = 2.0;
  });
  const auto halves = divideAtFrame(Evaluation(still), 45);
  ASSERT_TRUE(halves);
  EXPECT_EQ(*at(halves->flight, {0, 0}).duration, 0.8);
  EXPECT_NEAR(*at(halves->flight, {0, 1}).duration, 1.2, 1e-12);
}

TEST(Division, IsRefusedWhereASectionBeginsOrTheFlightEnds) {
  const Evaluation e(atOneKey());
  for (std::int64_t i = 0; i < e.sectionCount(); ++i) {
    EXPECT_EQ(divideAtFrame(e, e.section(i).firstFrame).error(), DivisionRefusal::kSectionBegins);
  }
  EXPECT_EQ(divideAtFrame(e, e.frameCount() - 1).error(), DivisionRefusal::kFlightEnds);
  EXPECT_EQ(divideAtPlace(e, 0, 0.0).error(), DivisionRefusal::kKeyIsThere);
  EXPECT_EQ(divideAtPlace(e, 0, 1.0).error(), DivisionRefusal::kKeyIsThere);
  EXPECT_EQ(divideAtPlace(e, 1, 0.5).error(), DivisionRefusal::kNoSuchPiece);
  const Flight short_ =
      withFirst(newFlight(), [](Key& key) { key.orientations[0].duration = 0.01; });
  EXPECT_EQ(divideAtPlace(Evaluation(short_), 0, 0.5).error(), DivisionRefusal::kOneFrame);
}

TEST(Division, IsRefusedOutsideTheCube) {
  Flight flight;  // keys -1, 1, 1, -1 reach 1.25
  for (const double x : {-1.0, 1.0, 1.0, -1.0}) {
    Key key;
    key.position = {x, 0.2 * static_cast<double>(flight.keys.size()), 0.5};
    flight.keys.push_back(key);
  }
  const Evaluation e(flight);
  EXPECT_EQ(divideAtPlace(e, 1, 0.5).error(), DivisionRefusal::kOutsideCube);
  EXPECT_EQ(divideAtFrame(e, e.frameOf({1, 0}) + 10).error(), DivisionRefusal::kOutsideCube);
}

// Ten values up to 100 can't run a curve that has become longer: both halves get durations.
TEST(Division, LeavesTheRateWhereTheSpeedsWouldGoBeyondTheirRange) {
  Flight flight;
  const Vec3 corners[] = {{-0.8, 0, 0}, {0.8, 0, 0.8}, {0.8, 0, -0.8}, {-0.8, 0, -0.7}};
  for (const Vec3& corner : corners) {
    Key key;
    key.position = corner;
    key.orientations[0].aim = {0, -0.5, 0};
    key.orientations[0].speed.fill(100.0);
    flight.keys.push_back(key);
  }
  const Evaluation before(flight);
  const std::int64_t n = before.frameOf({1, 0}) + 5;
  const auto division = divideAtFrame(before, n);
  ASSERT_TRUE(division);
  const bool byRate = !at(division->flight, {1, 0}).duration;
  EXPECT_EQ(byRate, !at(division->flight, {2, 0}).duration);
  EXPECT_FALSE(byRate);
  EXPECT_EQ(Evaluation(division->flight).frameCount(), before.frameCount());
}

}  // namespace
}  // namespace vides
