// SPDX-License-Identifier: MIT
// A roll of whole turns is no roll (2-flight-model, "Sections"): which sections have nothing to do.
#include "evaluate/idle_sections.hpp"

#include <gtest/gtest.h>

#include "evaluate/evaluation.hpp"

namespace vides {
namespace {

Key keyOf(double x, const std::vector<double>& rolls) {
  Key key;
  key.position = {x, 0.0, 0.0};
  key.orientations.clear();
  for (const double roll : rolls) {
    Orientation o;
    o.aimMode = AimMode::kRelative;
    o.aim = {0.0, 0.0, 1.0};
    o.roll = roll;
    key.orientations.push_back(o);
  }
  return key;
}

Flight flightOf(const std::vector<double>& rolls) {
  Flight flight;
  flight.keys = KeyList{keyOf(-0.5, rolls), keyOf(0.5, {rolls.back()})};
  return flight;
}

std::vector<std::int64_t> turnsOf(const Flight& flight) {
  std::vector<std::int64_t> turns;
  for (const IdleSection& idle : idleSections(flight)) turns.push_back(idle.turns);
  return turns;
}

using Turns = std::vector<std::int64_t>;

TEST(IdleSections, WholeTurnsAreNone) {
  EXPECT_EQ(turnsOf(flightOf({0.0, 360.0})), Turns{1});
  EXPECT_EQ(turnsOf(flightOf({360.0, 0.0})), Turns{1});
  EXPECT_EQ(turnsOf(flightOf({-180.0, 180.0})), Turns{1});
  EXPECT_EQ(turnsOf(flightOf({12.5, 1092.5})), Turns{3});
  EXPECT_EQ(turnsOf(flightOf({-36000.0, 36000.0})), Turns{200});
  EXPECT_EQ(turnsOf(flightOf({0.1, 360.1})), Turns{1});  // not exactly so in binary
  EXPECT_EQ(turnsOf(flightOf({0.0, 360.0, 720.0, 720.0})), (Turns{1, 1}));
  const auto idle = idleSections(flightOf({0.0, 0.0, 360.0}));
  ASSERT_EQ(idle.size(), 1u);
  EXPECT_EQ(idle[0].from, (OrientationPlace{0, 1}));
  EXPECT_EQ(idle[0].to, (OrientationPlace{0, 2}));
}

TEST(IdleSections, WhatDoesSomethingIsNone) {
  EXPECT_EQ(turnsOf(flightOf({0.0, 180.0})), Turns{});   // rolls by 180
  EXPECT_EQ(turnsOf(flightOf({0.0, -180.0})), Turns{});  // by -180
  EXPECT_EQ(turnsOf(flightOf({0.0, 540.0})), Turns{});
  EXPECT_EQ(turnsOf(flightOf({0.0, 361.0})), Turns{});
  EXPECT_EQ(turnsOf(flightOf({0.0, 0.0})), Turns{});  // nothing was meant
  Flight moves;
  moves.keys = KeyList{keyOf(-0.5, {0.0}), keyOf(0.5, {360.0})};
  EXPECT_EQ(turnsOf(moves), Turns{});
  Flight zooms = flightOf({0.0, 360.0});
  Key key = zooms.keys[0];
  key.orientations[1].zoom = 30.0;
  zooms.keys.set(0, key);
  EXPECT_EQ(turnsOf(zooms), Turns{});
  key.orientations[1].zoom = key.orientations[0].zoom;
  key.orientations[1].aim = {0.0, 1.0, 1.0};
  zooms.keys.set(0, key);
  EXPECT_EQ(turnsOf(zooms), Turns{});
}

// Between two keys in one place, over the seam, and with a duration: then it is a hold.
TEST(IdleSections, AlsoOverTheSeamAndWithADuration) {
  Flight flight;
  flight.keys = KeyList{keyOf(0.0, {0.0}), keyOf(0.5, {0.0}), keyOf(0.0, {720.0})};
  EXPECT_EQ(turnsOf(flight), Turns{});
  flight.closed = true;
  const auto idle = idleSections(flight);
  ASSERT_EQ(idle.size(), 1u);
  EXPECT_EQ(idle[0].from, (OrientationPlace{2, 0}));
  EXPECT_EQ(idle[0].to, (OrientationPlace{0, 0}));
  EXPECT_EQ(idle[0].turns, 2);

  Flight timed = flightOf({0.0, 360.0});
  Key key = timed.keys[0];
  key.orientations[0].duration = 2.0;
  timed.keys.set(0, key);
  EXPECT_EQ(turnsOf(timed), Turns{1});
  EXPECT_EQ(Evaluation(timed).section(0).kind, SectionKind::kHold);
}

TEST(IdleSections, NoMoreThanAskedFor) {
  const Flight flight = flightOf({0.0, 360.0, 0.0, 360.0, 0.0});
  EXPECT_EQ(idleSections(flight, 3).size(), 3u);
  EXPECT_EQ(idleSections(flight).size(), 4u);
}

}  // namespace
}  // namespace vides
