// SPDX-License-Identifier: MIT
// How crowded signs are, by cases that can be counted, and that nothing jumps.
#include "scene/crowding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "math/random_view.hpp"

namespace vides {
namespace {

using test::Random;
constexpr PixelRectangle kArea{0, 0, 800, 600};
constexpr double kCell = 17.5;

TEST(Crowding, OneAloneHasNoNeighbours) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    Crowding map;
    map.begin(kArea, kCell);
    const Vec2 place{random.between(0, 800), random.between(0, 600)};
    map.add(place);
    EXPECT_NEAR(map.around(place), 0.0, 1e-6);
  }
}

TEST(Crowding, WhatIsFarDoesNotCount) {
  Crowding map;
  map.begin(kArea, kCell);
  map.add({400, 300});
  for (int i = 0; i < 8; ++i) map.add(Vec2{400, 300} + 71.0 * Vec2{std::cos(i), std::sin(i)});
  EXPECT_LT(map.around({400, 300}), 0.02);
}

// In a row what counts is the distance, wherever the row lies and however it is turned.
TEST(Crowding, RowsAreMeasuredByTheirDistance) {
  Random random(2);
  for (int round = 0; round < 100; ++round) {
    const double apart = random.between(3, 12), angle = random.between(0, 7);
    const Vec2 way = apart * Vec2{std::cos(angle), std::sin(angle)};
    const Vec2 middle{random.between(300, 500), random.between(200, 400)};
    Crowding map;
    map.begin(kArea, kCell);
    for (int i = -30; i <= 30; ++i) map.add(middle + static_cast<double>(i) * way);
    EXPECT_NEAR(map.around(middle), 0.48 * kCell / apart - 0.23, 0.05 * kCell / apart + 0.03)
        << apart << " " << angle;
  }
}

TEST(Crowding, SurfacesAreMeasuredByTheirArea) {
  Crowding map;
  map.begin(kArea, kCell);
  for (int x = 0; x < 100; ++x) {
    for (int y = 0; y < 75; ++y) map.add({4.0 + 8.0 * x, 4.0 + 8.0 * y});
  }
  EXPECT_NEAR(map.around({404, 300}), kCell * kCell / 64 - 0.23, 0.05);
}

// Outside, beside the edge, far away, not a number: nothing but what reaches in.
TEST(Crowding, AnyPlaceIsTaken) {
  Crowding map;
  map.begin({100, 50, 10, 10}, kCell);
  for (const double v : {-1e300, -1.0, 0.0, 49.9, 99.9, 120.0, 1e300, std::nan("")}) {
    for (const double w : {-1e300, 49.0, 61.0, 1e300, std::nan("")}) {
      map.add({v, w});
      EXPECT_GE(map.around({v, w}), 0.0);
    }
  }
}

// Moved about for long, a crowd is measured to the last bit as if it had come where it is; and what
// is said to be as it was is so.
TEST(Crowding, WhatIsTakenAwayLeavesNothingBehind) {
  Random random(3);
  const auto anywhere = [&] { return Vec2{random.between(-40, 840), random.between(-40, 640)}; };
  std::vector<Vec2> places(500);
  Crowding map;
  map.begin(kArea, kCell);
  for (Vec2& place : places) map.add(place = anywhere());
  std::size_t kept = 0;
  for (int round = 0; round < 50; ++round) {
    EXPECT_TRUE(round > 0 || map.changed({400, 300}));
    map.settle();
    std::vector<double> before(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) before[i] = map.around(places[i]);
    const std::size_t moved = static_cast<std::size_t>(round * 37) % places.size();
    map.remove(places[moved]);
    map.add(places[moved] = anywhere());
    Crowding fresh;
    fresh.begin(kArea, kCell);
    for (const Vec2& place : places) fresh.add(place);
    for (std::size_t i = 0; i < places.size(); ++i) {
      ASSERT_EQ(map.around(places[i]), fresh.around(places[i]));
      if (i == moved || map.changed(places[i])) continue;
      ASSERT_EQ(map.around(places[i]), before[i]) << i;
      ++kept;
    }
  }
  EXPECT_GT(kept, 50u * 450u);  // most are far from what moved
}

TEST(CrossShare, WholeWhereThereIsRoom) {
  for (const std::size_t number : {0u, 1u, 2u, 1023u}) {
    EXPECT_EQ(crossShare(0.0, number), 1.0);
    EXPECT_EQ(crossShare(0.5, number), 1.0);
    EXPECT_LT(crossShare(0.6, number), 1.0);
  }
}

// However crowded, what is drawn covers about a twentieth of what it stands on, and thins no more
// than by half at a time.
TEST(CrossShare, OfManyEverySecondFourthEighthIsLeft) {
  for (const double crowding : {1.8, 2.6, 5.0, 9.0, 40.0, 700.0, 5000.0}) {
    int left = 0;
    constexpr int kAll = 1 << 14;
    for (std::size_t number = 0; number < kAll; ++number) {
      const double share = crossShare(crowding, number);
      EXPECT_GE(share, 0.0);
      EXPECT_LE(share, 0.31);
      left += share > 0.0 ? 1 : 0;
    }
    const double crowdingLeft = crowding * left / kAll;
    EXPECT_LE(crowdingLeft, 2.5) << crowding;
    EXPECT_GE(crowdingLeft, 0.9) << crowding;
  }
}

// What is left out where it is less crowded is left out where it is more so, and all the way there
// nothing jumps: the picture of a view that turns does not flicker.
TEST(CrossShare, ChangesSmoothlyAndOneWay) {
  for (const std::size_t number : {0u, 1u, 2u, 4u, 6u, 1024u}) {
    double before = 1.0;
    for (double crowding = 0.0; crowding < 50.0; crowding *= 1.001, crowding += 0.001) {
      const double share = crossShare(crowding, number);
      EXPECT_LE(share, before + 1e-12);
      EXPECT_GT(share, before - 0.01) << number << " at " << crowding;
      before = share;
    }
    EXPECT_EQ(before > 0.0, number % 32 == 0);
  }
}

}  // namespace
}  // namespace vides
