// SPDX-License-Identifier: MIT
// Problems told in the units that places are shown in.
#pragma once

#include "flight/flight.hpp"
#include "flight/problem.hpp"

namespace vides {

// A problem of a flight's keys, its ranges and what was found in scene units where they are places
// or offsets in cube units; others as they are. Numbers have 12 significant digits.
Problem inSceneUnits(Problem problem, const Flight& flight);

}  // namespace vides
