// SPDX-License-Identifier: MIT
// An update after any edit equals an evaluation from scratch, bit for bit; so does the walk.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "evaluate/evaluation.hpp"
#include "support/random_flight.hpp"

namespace vides {
namespace {

using test::Random;

::testing::AssertionResult sameSections(const Evaluation& a, const Evaluation& b) {
  if (a.sectionCount() != b.sectionCount()) {
    return ::testing::AssertionFailure()
           << "sections " << a.sectionCount() << " and " << b.sectionCount();
  }
  for (std::int64_t i = 0; i < a.sectionCount(); ++i) {
    const Section s = a.section(i);
    const Section t = b.section(i);
    if (s.index != t.index || s.kind != t.kind || s.from != t.from || s.to != t.to ||
        s.length != t.length || s.angle != t.angle || s.frames != t.frames ||
        s.firstFrame != t.firstFrame) {
      return ::testing::AssertionFailure() << "section " << i << " differs";
    }
    if (!(a.speedCurve(s.from) == b.speedCurve(s.from))) {
      return ::testing::AssertionFailure() << "speed curve of section " << i << " differs";
    }
  }
  return ::testing::AssertionSuccess();
}

// All that an evaluation tells, bit for bit.
::testing::AssertionResult same(const Evaluation& a, const Evaluation& b) {
  if (a.frameCount() != b.frameCount()) {
    return ::testing::AssertionFailure()
           << "frames " << a.frameCount() << " and " << b.frameCount();
  }
  if (a.length() != b.length()) return ::testing::AssertionFailure() << "length differs";
  if (auto sections = sameSections(a, b); !sections) return sections;
  FrameWalk walkA(a);
  FrameWalk walkB(b);
  Frame frameA, frameB;
  while (walkA.next(frameA)) {
    if (!walkB.next(frameB) || !(frameA == frameB)) {
      return ::testing::AssertionFailure() << "frame " << frameA.number << " differs";
    }
  }
  return ::testing::AssertionSuccess();
}

// What is asked for all at once is what is asked for one by one, and outside the changed ranges the
// pieces are the other evaluation's.
void expectPiecesTogether(const Evaluation& now, const Evaluation& before) {
  std::size_t next = 0;
  now.forEachPiece(0, now.pieceCount() + 5,
                   [&](std::size_t k, const void* identity, const CubicSegment& piece) {
                     EXPECT_EQ(k, next++);
                     EXPECT_EQ(identity, now.pieceIdentity(k));
                     EXPECT_EQ(&piece, &now.piece(k));
                   });
  EXPECT_EQ(next, now.pieceCount());
  if (now.flight().keys.size() != before.flight().keys.size()) return;
  std::size_t same = 0;
  for (const auto& range : now.changedPieces(before)) {
    ASSERT_LE(same, range.first);
    ASSERT_LT(range.first, range.last);
    ASSERT_LE(range.last, now.pieceCount());
    for (; same < std::min(range.first, before.pieceCount()); ++same) {
      ASSERT_EQ(now.pieceIdentity(same), before.pieceIdentity(same));
    }
    same = range.last;
  }
  for (; same < std::min(now.pieceCount(), before.pieceCount()); ++same) {
    ASSERT_EQ(now.pieceIdentity(same), before.pieceIdentity(same));
  }
}

TEST(IncrementalEvaluation, PiecesTogetherAreThePiecesOneByOne) {
  Random random(17);
  for (int round = 0; round < 20; ++round) {
    Flight flight = test::randomFlight(random, {.nasty = false, .mostKeys = 14});
    while (flight.keys.size() < 120) flight.keys.push_back(test::randomKey(random, false));
    Evaluation evaluation(flight);
    for (int edit = 0; edit < 20; ++edit) {
      test::editRandomly(random, flight, false);
      const Evaluation updated = evaluation.updated(flight);
      expectPiecesTogether(updated, evaluation);
      evaluation = updated;
    }
  }
}

// 10,000 edits of each kind of flight, 20 on end each.
void followEdits(bool nasty) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Random random(seed);
    Flight flight = test::randomFlight(random, {.nasty = nasty, .mostKeys = 14});
    Evaluation evaluation(flight);
    for (int edit = 0; edit < 20; ++edit) {
      test::editRandomly(random, flight, nasty);
      evaluation = evaluation.updated(flight);
      ASSERT_TRUE(same(evaluation, Evaluation(flight))) << "seed " << seed << " edit " << edit;
    }
  }
}

TEST(Incremental, EqualsScratchAfterAnyEdit) { followEdits(false); }
TEST(Incremental, EqualsScratchAfterAnyEditOfNastyFlights) { followEdits(true); }

// An edit early in a timed stretch moves the frames of all that follows in it.
TEST(Incremental, EqualsScratchInTimedStretches) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Random random(seed);
    Flight flight = test::randomFlight(random, {.nasty = seed % 2 == 0, .timed = true});
    if (seed % 10 == 0) {
      while (flight.keys.size() < 200) {
        Key key = test::randomKey(random, false);
        test::timeRandomly(random, flight.frameRate, key);
        flight.keys.push_back(std::move(key));
      }
    }
    Evaluation evaluation(flight);
    for (int edit = 0; edit < 20; ++edit) {
      if (test::chance(random, 0.5)) {
        const auto k = static_cast<std::size_t>(
            test::integer(random, 0, static_cast<int>(flight.keys.size()) - 1));
        Key key = flight.keys[k];
        test::timeRandomly(random, flight.frameRate, key);
        flight.keys.set(k, std::move(key));
      } else {
        test::editRandomly(random, flight, false);
      }
      evaluation = evaluation.updated(flight);
      ASSERT_TRUE(same(evaluation, Evaluation(flight))) << "seed " << seed << " edit " << edit;
    }
  }
}

// Long flights take the path that shares most of the tree.
TEST(Incremental, EqualsScratchInLongFlights) {
  for (const bool nasty : {false, true}) {
    Random random(nasty ? 77 : 76);
    Flight flight = test::randomFlight(random, {.nasty = nasty});
    flight.rates = {2.0, 2.0, 2.0, 2.0};
    while (flight.keys.size() < 400) flight.keys.push_back(test::randomKey(random, nasty));
    Evaluation evaluation(flight);
    for (int edit = 0; edit < 150; ++edit) {
      test::editRandomly(random, flight, nasty);
      evaluation = evaluation.updated(flight);
      ASSERT_TRUE(same(evaluation, Evaluation(flight))) << "nasty " << nasty << " edit " << edit;
    }
  }
}

// A change of sign early in the chain reaches a perpendicular pair at its end.
TEST(Incremental, ParityReachesFarAway) {
  Flight flight;
  flight.rates = {3.0, 10.0, 10.0, 10.0};
  std::vector<KeyPointer> keys;
  for (int k = 0; k < 300; ++k) {
    Key key;
    key.position = {std::cos(k * 0.2) * 0.5, k / 400.0, std::sin(k * 0.2) * 0.5};
    key.orientations[0].aimMode = AimMode::kRelative;
    key.orientations[0].aim = {0.0, 0.0, 1.0};
    keys.emplace_back(key);
  }
  Key last = *keys.back();
  last.orientations[0].aim = {0.0, 0.0, -1.0};
  keys.back() = KeyPointer(last);
  flight.keys = KeyList(std::move(keys));
  const Evaluation before(flight);
  const std::int64_t middle = before.frameCount() - 4;

  // A full turn of roll at one key flips all signs after it.
  Key turned = flight.keys[3];
  turned.orientations[0].roll = 360.0;
  flight.keys.set(3, turned);
  for (std::size_t k = 4; k < 299; ++k) {
    Key key = flight.keys[k];
    key.orientations[0].roll = 0.0;
    flight.keys.set(k, key);
  }
  Evaluation after = before.updated(flight);
  ASSERT_TRUE(same(after, Evaluation(flight)));
  EXPECT_EQ(before.frame(middle).camera, after.frame(middle).camera);

  // Only one of two changes of sign: the far pair turns the other way round.
  Flight odd = flight;
  for (std::size_t k = 4; k < 299; ++k) {
    Key key = odd.keys[k];
    key.orientations[0].roll = 360.0;
    odd.keys.set(k, key);
  }
  Flight even = odd;
  Key first = even.keys[298];
  first.orientations[0].roll = 0.0;
  even.keys.set(298, first);
  const Evaluation oddEvaluation = after.updated(odd);
  ASSERT_TRUE(same(oddEvaluation, Evaluation(odd)));
  ASSERT_TRUE(same(oddEvaluation.updated(even), Evaluation(even)));
}

// Where sections without frames lie between, an edit reaches further keys: the section before has
// another neighbour, so another mean speed, so (having a duration) another work, and that turns the
// joint before it differently.
TEST(Incremental, ReachesOverSectionsWithoutFrames) {
  Flight flight;
  std::vector<KeyPointer> keys;
  const double xs[] = {-0.9, -0.5, 0.0, 0.0, 0.0, 0.5, 0.9};
  const Vec3 aims[] = {{0, 0, 1},  {1, 0, 1}, {1, -1, 0}, {1, -1, 0},
                       {1, -1, 0}, {1, 0, 0}, {0, 0, 1}};
  for (std::size_t k = 0; k < 7; ++k) {
    Key key;
    key.position = {xs[k], 0.0, 0.0};
    key.orientations[0].aimMode = AimMode::kRelative;
    key.orientations[0].aim = aims[k];
    key.orientations[0].speed.fill(k == 3 ? 100.0 : 40.0);
    keys.emplace_back(key);
  }
  Key timed = *keys[1];
  timed.orientations[0].duration = 3.0;
  keys[1] = KeyPointer(timed);
  flight.keys = KeyList(std::move(keys));
  const Evaluation before(flight);

  Key moved = flight.keys[4];
  moved.position.y = 0.4;
  flight.keys.set(4, moved);
  const Evaluation after = before.updated(flight);
  ASSERT_TRUE(same(after, Evaluation(flight)));
  const std::int64_t n = after.section(0).frames - 10;
  EXPECT_FALSE(before.frame(n).camera == after.frame(n).camera);
}

TEST(Incremental, UnreachedPiecesAreShared) {
  Random random(5);
  Flight flight = test::randomFlight(random, {});
  while (flight.keys.size() < 100) flight.keys.push_back(test::randomKey(random, false));
  const Evaluation before(flight);
  Key key = flight.keys[50];
  key.position = {0.01, 0.02, 0.03};
  flight.keys.set(50, key);
  const Evaluation after = before.updated(flight);
  std::size_t changed = 0;
  for (std::size_t k = 0; k < after.pieceCount(); ++k) {
    if (before.pieceIdentity(k) != after.pieceIdentity(k)) ++changed;
  }
  EXPECT_EQ(changed, 4u);

  Key zoomed = key;
  zoomed.orientations[0].zoom = 50.0;
  flight.keys.set(50, zoomed);
  const Evaluation same = after.updated(flight);
  for (std::size_t k = 0; k < after.pieceCount(); ++k) {
    EXPECT_EQ(same.pieceIdentity(k), after.pieceIdentity(k)) << k;
  }
}

TEST(Frames, ByNumberEqualTheWalk) {
  for (std::uint64_t seed = 1; seed <= 250; ++seed) {
    Random random(seed);
    const Evaluation evaluation(
        test::randomFlight(random, {.nasty = seed % 2 == 0, .timed = seed % 4 > 1}));
    FrameWalk walk(evaluation);
    Frame frame;
    std::int64_t n = 0;
    while (walk.next(frame)) ASSERT_EQ(frame, evaluation.frame(n++)) << "seed " << seed;
    ASSERT_EQ(n, evaluation.frameCount());

    const std::int64_t first = test::integer(random, 0, static_cast<int>(n) - 1);
    FrameWalk part(evaluation, first, n + 5);
    for (std::int64_t i = first; i < n; ++i) {
      ASSERT_TRUE(part.next(frame));
      ASSERT_EQ(frame, evaluation.frame(i));
    }
    ASSERT_FALSE(part.next(frame));
  }
}

TEST(Frames, ManyThreadsReadOneEvaluation) {
  Random random(9);
  const Evaluation evaluation(test::randomFlight(random, {.nasty = true}));
  std::vector<Frame> expected;
  for (std::int64_t n = 0; n < evaluation.frameCount(); ++n)
    expected.push_back(evaluation.frame(n));
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      const Evaluation own = evaluation;
      Random mine(static_cast<std::uint64_t>(t));
      Flight flight = own.flight();
      test::editRandomly(mine, flight, true);
      if (!same(own.updated(flight), Evaluation(flight))) ++wrong;
      for (std::size_t n = 0; n < expected.size(); ++n) {
        if (!(own.frame(static_cast<std::int64_t>(n)) == expected[n])) ++wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace vides
