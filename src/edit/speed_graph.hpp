// SPDX-License-Identifier: MIT
// What the speed window draws of a section: speed, way and acceleration over its time, in numbers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "evaluate/evaluation.hpp"
#include "evaluate/joint.hpp"
#include "math/speed_curve.hpp"

namespace vides {

// In what a section's progress is measured.
enum class SectionUnit { kNone, kScene, kDegrees, kZoom };

struct SpeedGraph {
  struct Point {
    double tau = 0.0;           // share of the section's time
    double speed = 0.0;         // as it is used: limited, 1 to 100
    double drawn = 0.0;         // through the ten values without the limiter
    double way = 0.0;           // s(t), 0 to `amount`
    double acceleration = 0.0;  // units per second squared
  };
  std::vector<Point> points;      // tau from 0 to 1, ten handles among them
  std::array<bool, 9> limited{};  // the intervals between handles that the limiter changes
  Joint start, end;               // what the speed does there
  SectionKind kind = SectionKind::kHold;
  SectionUnit unit = SectionUnit::kNone;
  double amount = 0.0;  // in that unit: length, angle, zoom steps
  std::int64_t frames = 0;
  double seconds = 0.0;
  double perSpeed = 0.0;       // units per second that a speed value of 1 means here
  double mean = 0.0;           // units per second
  double fastest = 0.0;        // units per second
  double most = 0.0;           // largest |acceleration|
  std::int64_t idleTurns = 0;  // whole turns of roll that are all that differs: nothing is done
};

// Of the section that the orientation begins; nothing at an open flight's last one. `chords` of
// each of the nine intervals.
std::optional<SpeedGraph> speedGraph(const Evaluation& evaluation, const OrientationPlace& place,
                                     int chords = 12);

// A speed as a hand draws it: in multiples of `step`, from 1 to 100.
double drawnSpeed(double speed, double step = 1.0);
// The values after a stroke from one place of the graph to another: each handle that it
// crosses goes to the stroke's height there, and the one that it comes near to the pointer's;
// in multiples of `step`.
SpeedValues swept(const SpeedValues& values, double tau0, double speed0, double tau1, double speed1,
                  double step = 1.0);

}  // namespace vides
