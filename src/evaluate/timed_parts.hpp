// SPDX-License-Identifier: MIT
// Durations and holds that give whole numbers of frames where what is given in seconds is rounded
// together (2-flight-model, "Frames").
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evaluate/evaluation.hpp"

namespace vides {

// A section with a duration, or the hold before it, that is to have so many frames.
struct TimedPart {
  OrientationPlace place;
  bool hold = false;
  std::int64_t frames = 1;
  // With the part before it this one was a whole of so many seconds: it leaves the moment at which
  // the two end where it was, in fractions of a frame too, so that what follows is rounded as it
  // was. Nothing: it ends on a whole frame.
  std::optional<double> together;
};

// Sets the seconds of the parts, which have some that count as timed already. `evaluation` is of
// `flight`. Where a section too short to be divided (both halves count as a frame at least) moves
// what follows, the next timed section or hold gives way.
void settleTimedParts(Flight& flight, const Evaluation& evaluation,
                      const std::vector<TimedPart>& parts);

}  // namespace vides
