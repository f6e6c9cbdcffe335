// SPDX-License-Identifier: MIT
// A flight has at most limits::kFrames frames.
#pragma once

#include <optional>

#include "flight/flight.hpp"
#include "flight/problem.hpp"

namespace vides {

// kTooManyFrames at /keys. The flight must be valid (flight/validation.hpp). Evaluates it only
// where a bound on the number of frames leaves the question open.
std::optional<Problem> checkFrameCount(const Flight& flight);

// A number that frameCount() of the flight's evaluation doesn't exceed.
double frameCountBound(const Flight& flight);

}  // namespace vides
