// SPDX-License-Identifier: MIT
// What the speed window draws, against the frames of the same flight and formulas by hand.
#include "edit/speed_graph.hpp"

#include <gtest/gtest.h>

#include "edit/edit_fixture.hpp"

namespace vides {
namespace {

TEST(SpeedGraph, WayAndSpeedAreThoseOfTheFrames) {
  Session session;
  run(session, "set-space 0 0 0 20");
  run(session, "set-speed 10 20 40 60 80 90 70 50 30 20");
  const auto graph = speedGraph(session.evaluation(), session.current(), 50);
  ASSERT_TRUE(graph);
  const Evaluation& evaluation = session.evaluation();
  const Section section = *evaluation.sectionFrom({0, 0});
  EXPECT_EQ(graph->kind, SectionKind::kMove);
  EXPECT_EQ(graph->unit, SectionUnit::kScene);
  EXPECT_EQ(graph->frames, section.frames);
  EXPECT_NEAR(graph->amount, 1.0, 1e-9);  // the keys' distance in the scene stays
  EXPECT_NEAR(graph->mean, 1.0 / graph->seconds, 1e-9);
  const double fps = session.flight().frameRate;
  const auto worldX = [&](std::int64_t n) {
    return 20.0 * evaluation.frame(n).camera.viewReferencePoint.x;
  };
  // Between two frames: the middle's speed and acceleration by differences.
  for (const SpeedGraph::Point& p : graph->points) {
    const auto n = static_cast<std::int64_t>(p.tau * static_cast<double>(section.frames));
    if (n < 2 || n + 2 > section.frames) continue;
    EXPECT_NEAR(p.way, worldX(n) + 0.5, graph->fastest / fps + 1e-9);
    const double speed = fps * (worldX(n + 1) - worldX(n));
    EXPECT_NEAR(graph->perSpeed * p.speed, speed, 2.0 * graph->most / fps);
  }
  EXPECT_EQ(graph->points.front().way, 0.0);
  EXPECT_EQ(graph->points.back().way, graph->amount);
  // The way's slope is the speed, the speed's the acceleration.
  for (std::size_t i = 1; i + 1 < graph->points.size(); ++i) {
    const auto &a = graph->points[i - 1], &b = graph->points[i + 1];
    const double time = (b.tau - a.tau) * graph->seconds;
    EXPECT_NEAR((b.way - a.way) / time, graph->perSpeed * graph->points[i].speed,
                1e-3 * graph->fastest);
    EXPECT_NEAR(graph->perSpeed * (b.speed - a.speed) / time, graph->points[i].acceleration,
                0.03 * graph->most);
  }
}

TEST(SpeedGraph, ConstantSpeedHasNoAcceleration) {
  Session session;
  const auto graph = speedGraph(session.evaluation(), session.current());
  ASSERT_TRUE(graph);
  EXPECT_EQ(graph->most, 0.0);
  EXPECT_NEAR(graph->fastest, graph->mean, 1e-12);
  EXPECT_NEAR(graph->perSpeed * 50.0, graph->mean, 1e-12);
  for (const Joint& joint : {graph->start, graph->end}) {
    EXPECT_EQ(joint.meeting, Joint::Meeting::kNothing);
    EXPECT_FALSE(joint.value || joint.jumps || joint.stops());
  }
  EXPECT_EQ(graph->points.size(), 109u);
  EXPECT_FALSE(speedGraph(session.evaluation(), {1, 0}));  // an open flight's last
}

TEST(SpeedGraph, TellsWhereTheLimiterActs) {
  Session session;
  run(session, "set-speed 50 50 100 100 50 50 50 50 50 50");
  const auto graph = speedGraph(session.evaluation(), session.current());
  // The slope at the last of the two 100 is limited to 0 (and at the first): three intervals.
  const std::array<bool, 9> limited{false, true, true, true, false, false, false, false, false};
  EXPECT_EQ(graph->limited, limited);
  double most = 0.0;
  for (const SpeedGraph::Point& p : graph->points) {
    most = std::max(most, p.drawn);
    EXPECT_LE(p.speed, kMaxSpeed);
    if (p.tau < 1.0 / 9.0 || p.tau > 4.0 / 9.0) {
      EXPECT_EQ(p.drawn, p.speed) << p.tau;
    }
  }
  EXPECT_GT(most, kMaxSpeed + 1.0);
}

TEST(SpeedGraph, OfPansRollsZoomsAndNothing) {
  Session session;
  run(session, "insert-orientation");
  run(session, "select-key 0 0");
  auto graph = speedGraph(session.evaluation(), {0, 0});
  ASSERT_TRUE(graph);  // a section without frames
  EXPECT_EQ(graph->frames, 0);
  EXPECT_EQ(graph->perSpeed, 0.0);
  run(session, "set-roll 30");
  graph = speedGraph(session.evaluation(), {0, 0});
  EXPECT_EQ(graph->unit, SectionUnit::kDegrees);
  EXPECT_NEAR(graph->amount, 30.0, 1e-9);
  run(session, "set-roll 0");
  run(session, "set-zoom 60");
  graph = speedGraph(session.evaluation(), {0, 0});
  EXPECT_EQ(graph->unit, SectionUnit::kZoom);
  EXPECT_NEAR(graph->amount, 48.0, 1e-9);
  EXPECT_NEAR(graph->mean * graph->seconds, 48.0, 1e-9);
}

TEST(SpeedGraph, MarksJumpsToTheNeighbours) {
  Session session;
  makeFive(session);
  run(session, "select-key 2");
  run(session, "set-speed 20 50 50 50 50 50 50 50 50 50");
  const auto graph = speedGraph(session.evaluation(), {2, 0});
  EXPECT_EQ(graph->start.value, 50.0);
  EXPECT_TRUE(graph->start.jumps);
  EXPECT_FALSE(graph->end.jumps);
  run(session, "match-speed before");
  EXPECT_FALSE(speedGraph(session.evaluation(), {2, 0})->start.jumps);
}

TEST(SpeedGraph, ASweepSetsTheHandlesItCrosses) {
  SpeedValues values;
  values.fill(50.0);
  const SpeedValues once = swept(values, 2.0 / 9, 80.4, 2.0 / 9, 80.4);
  for (std::size_t j = 0; j < values.size(); ++j) EXPECT_EQ(once[j], j == 2 ? 80.0 : 50.0);
  const SpeedValues all = swept(values, -0.5, 1.0, 1.5, 200.0);
  for (std::size_t j = 0; j < values.size(); ++j) {
    const double tau = static_cast<double>(j) / 9.0;
    EXPECT_NEAR(all[j], std::clamp(1.0 + 199.0 * (tau + 0.5) / 2.0, 1.0, 100.0), 0.5) << j;
  }
  // The other way round the same; a fast stroke leaves none out.
  EXPECT_EQ(swept(values, 1.5, 200.0, -0.5, 1.0), all);
  const SpeedValues part = swept(values, 3.2 / 9, 10.0, 5.6 / 9, 90.0);
  EXPECT_EQ(part[2], 50.0);
  EXPECT_EQ(part[3], 50.0);  // left behind: the press has set it before
  EXPECT_NEAR(part[4], 10.0 + 80.0 * 0.8 / 2.4, 0.5);
  EXPECT_EQ(part[6], 90.0);
  EXPECT_EQ(part[7], 50.0);
  // In many small steps the same as in one.
  SpeedValues small = values;
  for (int i = 0; i < 100; ++i) {
    small =
        swept(small, -0.5 + i / 50.0, 1.0 + 1.99 * i, -0.5 + (i + 1) / 50.0, 1.0 + 1.99 * (i + 1));
  }
  for (std::size_t j = 0; j < values.size(); ++j) EXPECT_NEAR(small[j], all[j], 1.0) << j;
}

}  // namespace
}  // namespace vides
