// SPDX-License-Identifier: MIT
// Random valid flights and random edits of them, for properties. The same seed gives the same
// flight.
#pragma once

#include "flight/flight.hpp"
#include "math/random.hpp"

namespace vides::test {

// Uniform in [low, high], both included.
int integer(Random& random, int low, int high);
bool chance(Random& random, double probability);

struct FlightKind {
  // Poles, coincident and nearly coincident keys, perpendicular orientations, zero tangents,
  // sections in which nothing differs, extreme rolls and durations.
  bool nasty = false;
  int mostKeys = 12;
  // Most of it given in seconds: long timed stretches, holds around half a frame and one frame.
  bool timed = false;
};

Orientation randomOrientation(Random& random, const Key& key, bool nasty);
Key randomKey(Random& random, bool nasty);
Flight randomFlight(Random& random, const FlightKind& kind);

// Durations and holds in runs: all that is near them is given in seconds too.
void timeRandomly(Random& random, double frameRate, Key& key);

// One edit as a user makes them: of a key, an orientation, the list of keys, or the flight's rules.
void editRandomly(Random& random, Flight& flight, bool nasty);

}  // namespace vides::test
