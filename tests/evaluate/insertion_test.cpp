// SPDX-License-Identifier: MIT
// New keys on the curve and beyond its end (2-flight-model, "Insert"; 5-editor, "Append").
#include <gtest/gtest.h>

#include "evaluate/insertion.hpp"
#include "support/random_flight.hpp"

namespace vides {
namespace {

Flight straight() {
  Flight flight = newFlight();
  Key key = flight.keys[0];
  key.shape.preset = 3;
  key.orientations[0].hold = 1.0;
  key.orientations[0].duration = 8.0;
  key.orientations[0].roll = 7.0;
  flight.keys.set(0, key);
  return flight;
}

TEST(Insert, HalfwayTakesOverAndSplitsTheDuration) {
  const auto inserted = insertKeys(Evaluation(straight()), 0, 1);
  ASSERT_TRUE(inserted);
  ASSERT_EQ(inserted->keys.size(), 3u);
  const Key& key = inserted->keys[1];
  EXPECT_NEAR(key.position.x, 0.0, 1e-12);
  EXPECT_EQ(key.shape.preset, 3);
  EXPECT_EQ(key.orientations[0].roll, 7.0);
  EXPECT_EQ(key.orientations[0].hold, 0.0);
  EXPECT_EQ(key.orientations[0].duration, 4.0);
  EXPECT_EQ(inserted->keys[0].orientations[0].duration, 4.0);
  EXPECT_EQ(inserted->keys[0].orientations[0].hold, 1.0);
}

TEST(Insert, SeveralStandAtEqualArcLengths) {
  test::Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const Flight flight = test::randomFlight(random, {});
    const Evaluation e(flight);
    const std::size_t k =
        static_cast<std::size_t>(test::integer(random, 0, static_cast<int>(e.pieceCount()) - 1));
    const auto inserted = insertKeys(e, k, 4);
    if (!inserted) continue;
    ASSERT_EQ(inserted->keys.size(), flight.keys.size() + 4);
    for (int i = 1; i <= 4; ++i) {
      const Vec3 expected = glm::clamp(e.piecePoint(k, i / 5.0), Vec3(-1.0), Vec3(1.0));
      EXPECT_LT(glm::length(inserted->keys[k + static_cast<std::size_t>(i)].position - expected),
                1e-12);
    }
  }
}

TEST(Insert, IsRefusedAfterTheLastKeyOfAnOpenFlight) {
  Flight flight = straight();
  const auto refused = insertKeys(Evaluation(flight), 1, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(), InsertRefusal::kAfterLastKey);
  EXPECT_EQ(insertKeys(Evaluation(flight), 0, 11).error(), InsertRefusal::kTooMany);
  EXPECT_EQ(insertKeys(Evaluation(flight), 0, 0).error(), InsertRefusal::kTooMany);
  flight.closed = true;
  EXPECT_TRUE(insertKeys(Evaluation(flight), 1, 1));
}

TEST(Insert, IsRefusedOnTheAim) {
  Flight flight = straight();
  Key key = flight.keys[0];
  key.orientations[0].aim = {0.0, 0.2, 0.8};
  flight.keys.set(0, key);
  EXPECT_EQ(insertKeys(Evaluation(flight), 0, 1).error(), InsertRefusal::kAimAtKey);
}

TEST(Append, GoesAThirdFurtherAndStopsAtTheCube) {
  auto flight = appendKey(Evaluation(straight()));
  ASSERT_TRUE(flight);
  EXPECT_NEAR(flight->keys[2].position.x, 0.5 + 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(flight->keys[2].position.y, 0.2, 1e-12);
  int appended = 1;
  while (appended < 40) {
    const auto next = appendKey(Evaluation(*flight));
    if (!next) {
      EXPECT_EQ(next.error(), InsertRefusal::kNoRoom);
      break;
    }
    flight = next;
    EXPECT_LE(flight->keys.back().position.x, 1.0);
    ++appended;
  }
  EXPECT_LT(appended, 40);
}

TEST(Append, FollowsTheChordWhereTheTangentIsZero) {
  Flight flight = straight();
  Key key = flight.keys[1];
  key.shape.preset = KeyShape::kOwn;
  key.shape.own.tension = 1.0;
  flight.keys.set(1, key);
  const auto appended = appendKey(Evaluation(flight));
  ASSERT_TRUE(appended);
  EXPECT_NEAR(appended->keys[2].position.x, 0.5 + 1.0 / 3.0, 1e-12);
}

}  // namespace
}  // namespace vides
