// SPDX-License-Identifier: MIT
// The timeline's strip: each sample is the mean of what the flight does there, at every zoom.
#include "panels/flight_graphs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/random_flight.hpp"

namespace vides {
namespace {

// A roll of nine frames with a speed curve, a move.
Flight shortRoll() {
  Flight flight;
  flight.orientationCurve = orientationMethod("slerp");
  Key key;
  key.position = {0.5, 0.2, 0.8};
  key.orientations.front().aim = {0, 0, 0};
  key.orientations.front().duration = 0.36;
  key.orientations.front().speed = {1, 12, 30, 55, 80, 95, 100, 70, 30, 5};
  Orientation rolled = key.orientations.front();
  rolled.roll = 50.0;
  key.orientations.push_back(rolled);
  flight.keys.push_back(key);
  Key second;
  second.position = {-0.7, 0.1, 0.3};
  second.orientations.front() = rolled;
  flight.keys.push_back(second);
  return flight;
}

void measure(FlightGraphs& graphs, const Evaluation& evaluation) {
  graphs.follow(evaluation);
  static_cast<void>(graphs.quality());
  graphs.finish([](std::int64_t, std::int64_t) {});
}

// Finer than frames: the speed curve itself, no stairs.
TEST(SpeedStrip, AShortRollIsTheSpeedCurve) {
  const Evaluation evaluation(shortRoll());
  const auto roll = evaluation.sectionFrom({0, 0});
  ASSERT_TRUE(roll && roll->kind == SectionKind::kRoll);
  ASSERT_EQ(roll->frames, 9);
  FlightGraphs graphs;
  measure(graphs, evaluation);
  const double fine = 1.0 / 16.0;
  const SpeedStrip& strip = graphs.strip(0, fine, 9 * 16 + 40);
  const SpeedCurve& speed = evaluation.speedCurve({0, 0});
  for (std::size_t i = 0; i < 9 * 16; ++i) {
    const double begin = static_cast<double>(i) * fine / 9.0;
    const double wanted = 50.0 * (speed.progress(begin + fine / 9.0) - speed.progress(begin)) *
                          evaluation.flight().frameRate / fine;
    ASSERT_NEAR(static_cast<double>(strip.angularSpeed[i]), wanted, 1e-3) << i;
    ASSERT_NEAR(static_cast<double>(strip.speed[i]), 0.0, 1e-6) << i;
    ASSERT_TRUE(i == 0 || strip.angularSpeed[i] != strip.angularSpeed[i - 1]) << i;
  }
  for (std::size_t i = 9 * 16; i < strip.speed.size(); ++i) EXPECT_GT(strip.speed[i], 0.0f) << i;
}

// At any zoom the samples times their stretches make up the whole way and the whole turn.
TEST(SpeedStrip, NothingIsLostAtAnyZoom) {
  test::Random random(5);
  for (int round = 0; round < 20; ++round) {
    const Evaluation evaluation(test::randomFlight(random, {}));
    const std::int64_t last = evaluation.frameCount() - 1;
    if (last < 2) continue;
    double way = 0.0, turn = 0.0;
    for (std::int64_t n = 0; n < last; ++n) {
      const Camera a = evaluation.frame(n).camera, b = evaluation.frame(n + 1).camera;
      way += glm::distance(a.viewReferencePoint, b.viewReferencePoint);
      turn += rotationBetween(a, b) * 180.0 / std::numbers::pi;
    }
    FlightGraphs graphs;
    measure(graphs, evaluation);
    for (const double step : {0.3, 1.0, 1.7, 5.0, 23.4}) {
      const auto samples = static_cast<int>(std::ceil(static_cast<double>(last) / step));
      const SpeedStrip& strip = graphs.strip(0, step, samples);
      double wayThere = 0.0, turnThere = 0.0;
      for (int i = 0; i < samples; ++i) {
        const double frames = std::min(static_cast<double>(last), (i + 1) * step) - i * step;
        const double seconds = frames / evaluation.flight().frameRate;
        wayThere += static_cast<double>(strip.speed[static_cast<std::size_t>(i)]) * seconds;
        turnThere += static_cast<double>(strip.angularSpeed[static_cast<std::size_t>(i)]) * seconds;
      }
      // Between frames the curve is a little longer than the chord of a whole frame.
      const double more = step < 1.0 ? 0.1 : 1e-5;
      EXPECT_NEAR(wayThere, way, 1e-6 + more * way) << step;
      EXPECT_NEAR(turnThere, turn, 1e-6 + more * turn) << step;
      EXPECT_GE(wayThere, way * (1.0 - 1e-5)) << step;
    }
  }
}

// Scrolling keeps samples; they are those of a fresh look at the same place.
TEST(SpeedStrip, ScrolledIsTheSameAsFresh) {
  const Evaluation evaluation(shortRoll());
  for (const double step : {0.2, 3.0}) {
    FlightGraphs scrolled;
    measure(scrolled, evaluation);
    for (const std::int64_t first : {0, 3, 9, 2, 0, 5}) {
      const SpeedStrip& there = scrolled.strip(first, step, 12);
      FlightGraphs fresh;
      measure(fresh, evaluation);
      const SpeedStrip& wanted = fresh.strip(first, step, 12);
      for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_NEAR(there.angularSpeed[i], wanted.angularSpeed[i], 1e-3f) << first << " " << i;
        EXPECT_NEAR(there.speed[i], wanted.speed[i], 1e-5f) << first << " " << i;
      }
    }
  }
}

// At whole numbers the frame's camera, bit for bit; between them close to both.
TEST(CameraBetween, MeetsTheFrames) {
  test::Random random(6);
  for (int round = 0; round < 30; ++round) {
    const Evaluation evaluation(test::randomFlight(random, {}));
    const std::int64_t frames = evaluation.frameCount();
    for (int i = 0; i < 40; ++i) {
      const std::int64_t n = test::integer(random, 0, static_cast<int>(frames) - 1);
      EXPECT_EQ(evaluation.cameraBetween(static_cast<double>(n)), evaluation.frame(n).camera);
    }
    EXPECT_EQ(evaluation.cameraBetween(-1.0), evaluation.frame(0).camera);
    EXPECT_EQ(evaluation.cameraBetween(std::nan("")), evaluation.frame(0).camera);
    EXPECT_EQ(evaluation.cameraBetween(1e18), evaluation.frame(frames - 1).camera);
  }
}

}  // namespace
}  // namespace vides
