// SPDX-License-Identifier: MIT
// Speeds and durations with which a flight whose curve has been divided shows the same film.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evaluate/evaluation.hpp"

namespace vides {

// What a section of the divided flight is to run: a part of the time of a section before.
struct Course {
  OrientationPlace place;   // that begins it, in the divided flight
  std::int64_t frames = 1;  // that it must have
  SpeedCurve speed;         // of the section before …
  double from = 0.0;        // … and the part of its time
  double to = 1.0;
  bool byRate = true;  // neighbours: else it has a duration
};

// What must stay the same film.
struct DividedFilm {
  Flight flight;           // divided: the halves have the speed curve of the whole
  OrientationPlace place;  // of what has been inserted; it stands on …
  std::int64_t frame = 0;
  Course halves[2];
  // Seconds of the whole; nothing where it is by rate. Halves by rate stay so where speeds in
  // [1, 100] give their frames and their course, else they get durations.
  std::optional<double> duration;
  // Whole sections beside them: their curves may have bent, their speed goes on into the halves'.
  std::vector<Course> neighbours;
};

// The divided flight with speeds and durations set. `before` is the whole one's evaluation. Nothing
// where no frames are the same with them.
std::optional<Flight> keepFilm(const Evaluation& before, const DividedFilm& film);

}  // namespace vides
